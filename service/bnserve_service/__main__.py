"""``python -m bnserve_service`` is the ``bnserve`` command."""

import sys

from bnserve_service.cli import main

sys.exit(main())
