"""Where homes come from: drawn by seed, imported, or furnished by rules."""
