// SPDX-License-Identifier: Apache-2.0
// Palettes that the colour-blind can read: Okabe and Ito (2008) for lines, cividis (Nunez et al. 2018) for fields, and a
// blue-to-orange scale through grey for values of both signs.

export const lines = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7f7f7f"];
/// On dark ground the same hues, lighter.
export const lines_dark = ["#56b4e9", "#ff9a4d", "#2fd0a5", "#e6a3cb", "#f5c242", "#8fd0f5", "#b5b5b5"];

type Rgb = [number, number, number];
const cividis: Rgb[] = [[0, 34, 78], [18, 53, 112], [59, 73, 108], [87, 93, 109], [112, 113, 115], [138, 134, 120],
  [165, 156, 116], [195, 180, 104], [225, 204, 85], [254, 232, 56]];
const both_signs: Rgb[] = [[0, 70, 140], [70, 140, 200], [170, 200, 225], [230, 230, 230], [245, 205, 150],
  [225, 140, 50], [150, 70, 0]];

function on_scale(scale: Rgb[], part: number): Rgb {
  const place = Math.min(1, Math.max(0, part)) * (scale.length - 1);
  const lower = Math.min(scale.length - 2, Math.floor(place));
  const share = place - lower;
  return [0, 1, 2].map((i) => (scale[lower][i] + (scale[lower + 1][i] - scale[lower][i]) * share) / 255) as Rgb;
}

/// Colours of the values of a field; centred on `middle` when that is given.
export interface ColourScale { least: number; greatest: number; diverging: boolean; }

export function colour(scale: ColourScale, value: number): Rgb {
  const span = scale.greatest - scale.least;
  return on_scale(scale.diverging ? both_signs : cividis, span > 0 ? (value - scale.least) / span : 0.5);
}

export const stick: Rgb = [0.0, 0.447, 0.698];
export const slip: Rgb = [0.902, 0.624, 0.0];
export const apart: Rgb = [0.75, 0.75, 0.75];
export const css = (rgb: Rgb) => `rgb(${rgb.map((part) => Math.round(part * 255)).join(",")})`;
export const is_dark = () => document.documentElement.dataset.theme === "dark"
  || (!document.documentElement.dataset.theme && matchMedia("(prefers-color-scheme: dark)").matches);
export const line_colours = () => (is_dark() ? lines_dark : lines);
