"""How cost grows: time against batch, grid, clients and loaded models up to the limits, and where memory takes over."""
