# SPDX-License-Identifier: Apache-2.0
"""Who may connect to a cluster: this machine alone, or holders of the cluster's certificate.

The protocol of Dask carries pickles: whoever can connect can run code.
"""

import ipaddress
import json
import pathlib
import socket
import stat
import subprocess
from urllib.parse import urlsplit

from ..errors import CaseError

SCHEDULER = "scheduler.json"
CERTIFICATE, KEY = "certificate.pem", "key.pem"
DAYS = 3650


def require_distributed():
    """Raises CaseError with the remedy where Dask is missing."""
    try:
        import distributed  # pylint: disable=import-outside-toplevel,unused-import
    except ImportError as missing:
        raise CaseError("clusters need Dask's distributed, which is missing\n  = install python3-distributed, or share the "
                        "work without it: ionskin sweep --plan, --do-batch and --collect") from missing


def is_loopback(host):
    """Whether an address or a name stands for this machine alone. Raises CaseError for an unknown name."""
    try:
        found = {entry[4][0] for entry in socket.getaddrinfo(host, None)}
    except OSError as error:
        raise CaseError(f"the address {host} is unknown: {error.strerror}") from error
    return all(ipaddress.ip_address(address.split("%")[0]).is_loopback for address in found)


def make_certificate(folder):
    """A key and a certificate of the cluster, for the scheduler, its workers and clients alike; mode 600."""
    folder = pathlib.Path(folder)
    for name in (CERTIFICATE, KEY):
        (folder / name).unlink(missing_ok=True)
        (folder / name).touch(mode=0o600)
    command = ["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-days",
               str(DAYS), "-subj", "/CN=ionskin cluster", "-keyout", folder / KEY, "-out", folder / CERTIFICATE]
    try:
        subprocess.run(command, check=True, capture_output=True)
    except FileNotFoundError as missing:
        raise CaseError("--tls needs the program openssl\n  = install the package openssl") from missing


def tls(folder):
    """Dask's Security with the certificate of a cluster's folder. Raises CaseError."""
    from distributed.security import Security  # pylint: disable=import-outside-toplevel
    certificate, key = (pathlib.Path(folder) / name for name in (CERTIFICATE, KEY))
    for path in (certificate, key):
        if not path.is_file():
            raise CaseError(f"the cluster takes TLS, and {path} is missing\n  = copy {CERTIFICATE} and {KEY} of the cluster "
                            f"beside its {SCHEDULER}")
    if stat.S_IMODE(key.stat().st_mode) & 0o077:
        raise CaseError(f"{key} can be read by others, who could then run code in the cluster\n  = chmod 600 {key}, or start "
                        "the cluster anew with --tls")
    parts = {f"tls_{part}_{what}": str(path) for part in ("scheduler", "worker", "client")
             for what, path in (("cert", certificate), ("key", key))}
    return Security(tls_ca_file=str(certificate), require_encryption=True, **parts)


def read_scheduler(path):
    """Address and Security from the file of a scheduler. Raises CaseError."""
    path = pathlib.Path(path)
    try:
        address = json.loads(path.read_text(encoding="utf-8"))["address"]
        parts = urlsplit(address)
        host = parts.hostname
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise CaseError(f"{path} is no file of a scheduler: {error}\n  = start a cluster: ionskin cluster start FOLDER, and "
                        f"name FOLDER/{SCHEDULER}") from error
    require_distributed()
    if parts.scheme == "tls":
        return address, tls(path.parent)
    if not host or not is_loopback(host):
        raise CaseError(f"the scheduler at {address} takes connections from other machines without encryption, and whoever "
                        "connects can run code\n  = start it with: ionskin cluster start FOLDER --tls --address ADDRESS")
    return address, None
