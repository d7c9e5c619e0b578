"""What ``bnserve doctor`` looks at: installation, stores, machine, and a server."""
