"""``bnserve demo``: the one place of the service that uses the client, and that draws."""
