"""The program: ``etalon`` and ``python -m etalon``."""

import signal
import sys

from ._etalon import main as _main


def main() -> None:
    """Run the program with the arguments of the process, and end with its exit code."""
    # Python's handlers would wait until the computation ends
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    sys.exit(_main(["etalon", *sys.argv[1:]]))


if __name__ == "__main__":
    main()
