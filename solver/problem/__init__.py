"""Problem files: from YAML text to an exact, validated `Problem`, with errors that name their place."""
