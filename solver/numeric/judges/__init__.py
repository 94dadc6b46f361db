"""The judges of answers by their defining properties, one package a topic; a stub says which names tasks may use."""
