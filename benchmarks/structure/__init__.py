"""How large the code is, and how many modules one answer passes."""
