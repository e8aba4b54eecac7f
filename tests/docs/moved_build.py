# SPDX-License-Identifier: Apache-2.0
"""Moves a copy of a Ninja build folder to another place without everything having to be built again."""

import json
import os
import struct
import subprocess

WORD = (1 << 64) - 1


def command_hash(command):
    """MurmurHash64A as ninja 1.11 keeps it of every command in .ninja_log."""
    data, m = command.encode(), 0xC6A4A7935BD1E995
    value = 0xDECAFBADDECAFBAD ^ (len(data) * m & WORD)
    whole = len(data) // 8 * 8
    for (k,) in struct.iter_unpack("<Q", data[:whole]):
        k = k * m & WORD
        value = (value ^ ((k ^ k >> 47) * m & WORD)) * m & WORD
    if rest := data[whole:]:
        value = (value ^ int.from_bytes(rest, "little")) * m & WORD
    value = (value ^ value >> 47) * m & WORD
    return value ^ value >> 47


def replace_in(file, old, new):
    """Replaces a path in a text file and keeps the file's time."""
    text = file.read_text(errors="surrogateescape")
    if old in text:
        times = file.stat()
        file.write_text(text.replace(old, new), errors="surrogateescape")
        os.utime(file, ns=(times.st_atime_ns, times.st_mtime_ns))


def moved_dependencies(data, old, new):
    """Ninja's record of the headers that each object was made of (version 4), with a path replaced.

    Records are a length and content: a path, padded to words, with the complement of its number, or, with the
    highest bit of the length set, numbers of paths.
    """
    heading = b"# ninjadeps\n" + struct.pack("<i", 4)
    if not data.startswith(heading):
        return data
    records, at = [heading], len(heading)
    while at < len(data):
        (size,) = struct.unpack_from("<I", data, at)
        content = data[at + 4:at + 4 + (size & 0x7FFFFFFF)]
        at += 4 + len(content)
        if not size & 0x80000000:
            path, number = content[:-4].rstrip(b"\0").replace(old, new), content[-4:]
            content = path + bytes(-len(path) % 4) + number
            size = len(content)
        records += [struct.pack("<I", size), content]
    return b"".join(records)


def move_build(folder, old, new):
    """Makes the copy `folder` of a build of the tree `old` a build of the tree `new`.

    Paths are replaced in the files of CMake and Ninja and in the sources that include others to be compiled
    together. Ninja remembers the hash of each command; those that only changed their path get the new one. Where
    Ninja has another format everything is built again.
    """
    for file in folder.rglob("*"):
        if file.suffix in (".ninja", ".cmake", ".txt", ".cxx") and file.is_file() and not file.is_symlink():
            replace_in(file, str(old), str(new))
    dependencies = folder / ".ninja_deps"
    dependencies.write_bytes(moved_dependencies(dependencies.read_bytes(), bytes(old), bytes(new)))
    commands = json.loads(subprocess.run(["ninja", "-C", folder, "-t", "compdb"], capture_output=True, text=True,
                                         check=True).stdout)
    # By the old hash: a command may have several outputs, of which only the first is named.
    hashes = {f"{command_hash(entry['command'].replace(str(new), str(old))):x}": f"{command_hash(entry['command']):x}"
              for entry in commands}
    log = folder / ".ninja_log"
    lines = []
    for line in log.read_text().splitlines():
        fields = line.split("\t")
        if len(fields) == 5:
            fields[3:] = [fields[3].replace(str(old), str(new)), hashes.get(fields[4], fields[4])]
        lines.append("\t".join(fields))
    log.write_text("\n".join(lines) + "\n")
