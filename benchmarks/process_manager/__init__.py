"""Other managers of processes, under the promises of ours."""
