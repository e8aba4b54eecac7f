// SPDX-License-Identifier: Apache-2.0
// Tables of a list in the text of a case, `[[skin.layers]]`: each a block of lines to its next heading.

function pattern(list: string): RegExp {
  return new RegExp(`^\\[\\[${list.replace(/\./g, "\\.")}\\]\\][^\\n]*\\n(?:(?!\\s*\\[)[^\\n]*(?:\\n|$))*`, "gm");
}

export function blocks(text: string, list: string): string[] {
  return text.match(pattern(list)) ?? [];
}

/// Value that a block gives to a name, as it stands there; empty where it says nothing.
export function written_in(block: string, name: string): string {
  return new RegExp(`^\\s*${name}\\s*=\\s*("(?:[^"\\\\\\n]|\\\\.)*"|'[^'\\n]*'|\\[[^\\]]*\\]|[^#\\n]*)`, "m").exec(block)?.[1].trim() ?? "";
}

export function without_block(text: string, list: string, index: number): string {
  let i = 0;
  return text.replace(pattern(list), (one) => (i++ === index ? "" : one));
}

export function without_blocks(text: string, list: string): string {
  return text.replace(pattern(list), "");
}

/// A block and the one before it change places.
export function with_block_before(text: string, list: string, index: number): string {
  const all = blocks(text, list).map((one) => (one.endsWith("\n") ? one : `${one}\n`));
  let i = 0;
  return text.replace(pattern(list), () => {
    const k = i++;
    return k === index - 1 ? all[index] : k === index ? all[index - 1] : all[k];
  });
}

/// A block behind the last of its list, or at the end of a text that has none.
export function with_block(text: string, list: string, block: string): string {
  const last = [...text.matchAll(pattern(list))].pop();
  if (!last) return `${text.trimEnd()}\n\n${block.trim()}\n`;
  const end = last.index + last[0].length;
  return `${text.slice(0, end).trimEnd()}\n\n${block.trim()}\n${text.slice(end).trim() ? "\n" : ""}${text.slice(end).trimStart()}`;
}
