"""What students write: answer files, spellings, values."""
