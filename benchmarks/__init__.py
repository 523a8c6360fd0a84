"""Every contestant over the same models, interleaved in one process."""
