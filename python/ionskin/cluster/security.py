# SPDX-License-Identifier: Apache-2.0
"""Access to a cluster: this machine alone, or holders of the cluster's certificate.

The protocol of Dask carries pickles: whoever can connect can run code.
"""

import ipaddress
import pathlib
import socket
import stat
import subprocess
from urllib.parse import urlsplit

from ..errors import CaseError
from ..reading import files

SCHEDULER = "scheduler.json"
CERTIFICATE, KEY = "certificate.pem", "key.pem"
DAYS = 3650
REACH = 5  # seconds to wait for a connection


def require_distributed():
    """Raises CaseError with the remedy where Dask is missing."""
    try:
        import distributed  # pylint: disable=import-outside-toplevel,unused-import
    except ImportError as missing:
        raise CaseError("clusters need Dask's distributed, which is missing\n  = install python3-distributed, or share the "
                        "work without it: ionskin sweep --plan, --do-batch and --collect") from missing


def is_loopback(host):
    """True if an address or a host name means this machine itself. Raises CaseError for an unknown name."""
    try:
        found = {entry[4][0] for entry in socket.getaddrinfo(host, None)}
    except OSError as error:
        raise CaseError(f"the address {host} is unknown: {error.strerror}") from error
    return all(ipaddress.ip_address(address.split("%")[0]).is_loopback for address in found)


def make_certificate(folder):
    """Makes key and certificate of a cluster in its folder, readable only by the user; scheduler, workers and clients
    share them.

    Raises CaseError without openssl.
    """
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
    """Makes Dask's Security of the certificate in a cluster's folder. Raises CaseError when
    it is missing or others can read its key."""
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


def _address(path):
    """Reads address and host name from the file of a scheduler. Raises CaseError when it is no such file."""
    remedy = f"start a cluster: ionskin cluster start FOLDER, and name FOLDER/{SCHEDULER}"
    try:
        address = files.read_json(path, remedy=remedy)["address"]
        parts = urlsplit(address)
        if parts.scheme not in ("tcp", "tls") or not parts.hostname or not parts.port:
            raise ValueError("its address is none")
    except CaseError as error:
        raise CaseError(f"{path} is not a file of a scheduler: {error}") from error
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        what = error.strerror if isinstance(error, OSError) else f"address {error}" if isinstance(error, KeyError) else error
        raise CaseError(f"{path} is not a file of a scheduler: {what}\n  = {remedy}") from error
    return address, parts.hostname


def require_listening(address, path):
    """Requires that a scheduler listens at an address; `path` is its file, for
    messages. Raises CaseError when it was killed."""
    parts = urlsplit(address)
    try:
        socket.create_connection((parts.hostname, parts.port), timeout=REACH).close()
    except OSError as error:
        raise CaseError(f"the scheduler at {address}, which {path} names, does not answer: {error.strerror or error}\n  = start "
                        "the cluster again: ionskin cluster start FOLDER") from error


def read_scheduler(path):
    """Reads the file of a scheduler: its address, and its Security, None without TLS.
    Raises CaseError when it cannot be used safely."""
    path = pathlib.Path(path)
    address, host = _address(path)
    require_distributed()
    if address.startswith("tls:"):
        return address, tls(path.parent)
    if not is_loopback(host):
        raise CaseError(f"the scheduler at {address} takes connections from other machines without encryption, and whoever "
                        "connects can run code\n  = start it with: ionskin cluster start FOLDER --tls --address ADDRESS")
    return address, None
