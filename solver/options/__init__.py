"""The kinds of option a task can take, one file each; a task imports those it declares.

A kind reads a node of the file, and says in words, in the schema and by an example what is written.
"""
