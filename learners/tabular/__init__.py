"""Tables of values: how they are kept, updated and learned from."""
