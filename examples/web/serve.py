#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""serve.py FOLDER PORT: serves the playground in FOLDER on the loopback interface until it is stopped.

Says where once it answers; port 0 is any free one. Exits with 1 where there is no playground, or the port is not to be had.
"""
import functools
import http.server
import pathlib
import sys


class Handler(http.server.SimpleHTTPRequestHandler):
    extensions_map = {"": "application/octet-stream", ".html": "text/html", ".css": "text/css", ".js": "text/javascript"}

    def end_headers(self):
        self.send_header("Cache-Control", "no-cache")  # Or a page of an earlier build would get this one's module.
        super().end_headers()

    def log_message(self, *_):
        pass


def main(folder, port):
    if not pathlib.Path(folder, "index.html").is_file():
        return f"serve.py: {folder}: no playground: examples/web/build.sh makes it"
    try:
        server = http.server.ThreadingHTTPServer(("127.0.0.1", int(port)), functools.partial(Handler, directory=folder))
    except (OSError, OverflowError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else "a port is a number from 0 to 65535"
        return f"serve.py: port {port}: {reason}: examples/web/serve.sh PORT takes another one"
    print(f"The playground: http://127.0.0.1:{server.server_port}/", flush=True)
    try:
        server.serve_forever()
    except KeyboardInterrupt:
        return None


if len(sys.argv) != 3:
    sys.exit("usage: serve.py FOLDER PORT")
sys.exit(main(*sys.argv[1:]))
