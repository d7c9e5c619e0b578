"""The search for hyper-parameters, and the lookup of what it found."""
