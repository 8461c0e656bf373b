import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, test } from "vitest";

type Triple = readonly [number, number, number];
type Matrix = readonly [Triple, Triple, Triple];

/** Machado, Oliveira and Fernandes 2009, severity 1: linear sRGB as these eyes see it. */
const EYES: Readonly<Record<string, Matrix>> = {
  normal: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  protanope: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  deuteranope: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  tritanope: [
    [1.255528, -0.076749, -0.178779],
    [-0.078411, 0.930809, 0.147602],
    [0.004733, 0.691367, 0.3039],
  ],
};
/** Linear sRGB to XYZ, by the white D65. */
const TO_XYZ: Matrix = [
  [0.4124564 / 0.95047, 0.3575761 / 0.95047, 0.1804375 / 0.95047],
  [0.2126729, 0.7151522, 0.072175],
  [0.0193339 / 1.08883, 0.119192 / 1.08883, 0.9503041 / 1.08883],
];

const times = (matrix: Matrix, [a, b, c]: Triple): Triple =>
  matrix.map(([x, y, z]) => x * a + y * b + z * c) as unknown as Triple;
const linear = (hex: string): Triple =>
  [1, 3, 5].map((from) => {
    const value = Number.parseInt(hex.slice(from, from + 2), 16) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  }) as unknown as Triple;
const luminance = (hex: string): number => times(TO_XYZ, linear(hex))[1];
const contrast = (a: string, b: string): number => {
  const [dark = 0, light = 0] = [luminance(a), luminance(b)].toSorted((x, y) => x - y);
  return (light + 0.05) / (dark + 0.05);
};

/** CIELAB of a colour as these eyes see it. */
function lab(hex: string, eyes: Matrix): Triple {
  const seen = times(eyes, linear(hex)).map((value) => Math.max(0, Math.min(1, value))) as unknown as Triple;
  const [x, y, z] = times(TO_XYZ, seen).map((t) =>
    t > 216 / 24389 ? Math.cbrt(t) : (t * 24389) / 27 / 116 + 16 / 116,
  ) as unknown as Triple;
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

const radians = (degrees: number) => (degrees * Math.PI) / 180;
const degrees = (a: number, b: number) => ((Math.atan2(b, a) * 180) / Math.PI + 360) % 360;

/** CIEDE2000. */
function difference([l1, a1, b1]: Triple, [l2, a2, b2]: Triple): number {
  const grey = (chroma: number) => Math.sqrt(chroma ** 7 / (chroma ** 7 + 25 ** 7));
  const stretch = 1 + (1 - grey((Math.hypot(a1, b1) + Math.hypot(a2, b2)) / 2)) / 2;
  const [c1, c2] = [Math.hypot(a1 * stretch, b1), Math.hypot(a2 * stretch, b2)];
  const [h1, h2] = [degrees(a1 * stretch, b1), degrees(a2 * stretch, b2)];
  const turn = ((h2 - h1 + 540) % 360) - 180;
  const [l, c, h] = [(l1 + l2) / 2, (c1 + c2) / 2, (h1 + turn / 2 + 360) % 360];
  const t =
    1 -
    0.17 * Math.cos(radians(h - 30)) +
    0.24 * Math.cos(radians(2 * h)) +
    0.32 * Math.cos(radians(3 * h + 6)) -
    0.2 * Math.cos(radians(4 * h - 63));
  const lightness = (l2 - l1) / (1 + (0.015 * (l - 50) ** 2) / Math.sqrt(20 + (l - 50) ** 2));
  const chroma = (c2 - c1) / (1 + 0.045 * c);
  const hue = (2 * Math.sqrt(c1 * c2) * Math.sin(radians(turn / 2))) / (1 + 0.015 * c * t);
  const rotation = -2 * grey(c) * Math.sin(radians(60 * Math.exp(-(((h - 275) / 25) ** 2))));
  return Math.sqrt(lightness ** 2 + chroma ** 2 + hue ** 2 + rotation * chroma * hue);
}

const sheet = (name: string) => readFileSync(join("src", "app", "base", "styles", `${name}.css`), "utf8");
const declared = (css: string): Readonly<Record<string, string>> =>
  Object.fromEntries(
    [...css.matchAll(/--([\w-]+): (#[0-9a-f]{6});/g)].map(([, name = "", value = ""]) => [name, value]),
  );
/** The colours of both themes, as usual and with more contrast; both sheets have the dark ones after the light ones. */
const themes = (["tokens", "contrast"] as const).map((name) => {
  const css = sheet(name);
  const dark = css.indexOf(':root[data-theme="dark"]');
  return { light: declared(css.slice(0, dark)), dark: declared(css.slice(dark)) };
});
const THEMES = (["light", "dark"] as const).flatMap((theme) => {
  const usual = themes[0]?.[theme] ?? {};
  return [
    { theme, kind: "usual", colours: usual },
    { theme, kind: "more contrast", colours: { ...usual, ...themes[1]?.[theme] } },
  ];
});

/** Colours that are seen side by side with each other, and how far apart they are for all eyes at least. */
const APART = [
  ["residual", "accent", 12],
  ["residual", "danger", 15],
  ["residual", "contour", 12],
  ["residual", "material", 25],
  ["feed", "rapid", 15],
  ["accent", "danger", 20],
] as const;
const LOADS = [0, 1, 2, 3, 4, 5, 6].map((n) => `load-${n}`);

test("the difference of colours is that of the published examples", () => {
  expect(difference([50, 2.6772, -79.7751], [50, 0, -82.7485])).toBeCloseTo(2.0425, 4);
  expect(difference([50, 2.5, 0], [73, 25, -18])).toBeCloseTo(27.1492, 4);
  expect(difference([22.7233, 20.0904, -46.694], [23.0331, 14.973, -42.5619])).toBeCloseTo(2.0373, 4);
});

describe.each(THEMES)("$theme, $kind", ({ theme, colours }) => {
  const of = (name: string): string => colours[name] ?? expect.fail(`${name} is a colour`);

  test.each(Object.keys(EYES))("colours with a meaning differ for a %s", (eyes) => {
    const matrix = EYES[eyes] as Matrix;
    for (const [a, b, least] of APART)
      expect(difference(lab(of(a), matrix), lab(of(b), matrix)), `${a}, ${b}`).toBeGreaterThan(least);
  });

  test.each(Object.keys(EYES))(
    "each load is darker on light and lighter on dark than the one before, for a %s",
    (eyes) => {
      const seen = LOADS.map((name) => lab(of(name), EYES[eyes] as Matrix));
      for (const [i, now] of seen.entries()) {
        const before = seen[i - 1];
        if (!before) continue;
        expect((now[0] - before[0]) * (theme === "light" ? -1 : 1), `lightness ${i}`).toBeGreaterThan(2.5);
        expect(difference(before, now), `load ${i}`).toBeGreaterThan(7);
      }
    },
  );

  test("lines are seen on the material and text on the page", () => {
    for (const name of ["residual", "accent", ...LOADS])
      expect(contrast(of(name), of("material")), name).toBeGreaterThan(3);
    for (const name of ["residual", "accent", "danger", "warning", "good", "text-soft"])
      for (const ground of ["surface", "surface-raised"])
        expect(contrast(of(name), of(ground)), `${name} on ${ground}`).toBeGreaterThan(4.5);
  });
});

test.each(["light", "dark"] as const)("more contrast is more contrast, %s", (theme) => {
  const [usual, more] = themes.map((each) => each[theme]);
  const ground = usual?.["surface"] ?? "";
  const names = Object.keys(more ?? {});
  expect(names.length).toBeGreaterThan(5);
  for (const name of names) {
    const [now, before] = [contrast(more?.[name] ?? "", ground), contrast(usual?.[name] ?? "", ground)];
    expect(now, name).toBeGreaterThan(before);
    // AAA for text; the thin lines between areas are no text.
    if (name !== "line") expect(now, name).toBeGreaterThan(7);
  }
});
