"""The demonstration on recorded GPS observations: data, readers, positioning, summary."""
