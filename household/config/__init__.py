"""Reading configuration: TOML into frozen records, with the path of every fault."""
