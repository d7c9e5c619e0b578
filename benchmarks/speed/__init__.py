"""The table of speeds that bnserve is held to, measured side by side with its peers in one run."""
