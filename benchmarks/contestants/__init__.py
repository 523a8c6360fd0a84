"""Who takes part: each module writes the code of one rival, or of symnav, for any problem."""
