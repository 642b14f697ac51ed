"""The failure modes that tools/stability sweeps over, and what they share."""
