"""Fetches the files of public.toml into a folder: fetch_public.py FOLDER.

A file that is there already, or whose SHA-256 is another one, is not written.
"""

import hashlib
import pathlib
import sys
import tomllib
import urllib.parse
import urllib.request

folder = pathlib.Path(sys.argv[1])
listed = tomllib.loads(pathlib.Path(__file__).with_name("public.toml").read_text())
missing = 0
for file in listed["file"]:
    path = folder / file["repository"].replace("/", "+") / file["path"]
    if path.exists():
        continue
    address = "/".join([file["repository"], file["commit"], urllib.parse.quote(file["path"])])
    try:
        with urllib.request.urlopen(f"https://raw.githubusercontent.com/{address}", timeout=60) as answer:
            content = answer.read()
    except OSError as error:
        print(f"{address}: {error}", file=sys.stderr)
        missing += 1
        continue
    if hashlib.sha256(content).hexdigest() != file["sha256"]:
        print(f"{address}: another file than the list states", file=sys.stderr)
        missing += 1
        continue
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)
sys.exit(missing > 0)
