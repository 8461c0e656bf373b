import { readFileSync } from "node:fs";
import { join } from "node:path";
import { Color } from "three";
import { describe, expect, test } from "vitest";
import { groundOf } from "./surface-material.ts";
import { chuckTones, LIGHT, toned } from "./tone.ts";

const sheet = readFileSync(join("src", "app", "base", "styles", "tokens.css"), "utf8");
/** The colours of a theme; the sheet has the dark ones after the light ones. */
function tokensOf(theme: "light" | "dark"): (name: string) => string {
  const from = theme === "light" ? 0 : sheet.indexOf(':root[data-theme="dark"]');
  return (name) =>
    new RegExp(`${name}: (#[0-9a-f]{6});`).exec(sheet.slice(from))?.[1] ?? expect.fail(`${name} is a colour`);
}

const [x, y, z] = LIGHT.from;
/** Light from a surface of colour 1 that faces the eye, faces the light, or is turned away from it. */
const SEEN = {
  eye: LIGHT.around + (LIGHT.key * z) / Math.hypot(x, y, z),
  light: LIGHT.around + LIGHT.key,
  away: LIGHT.around,
} as const;

const luminance = ({ r, g, b }: Color) => 0.2126 * r + 0.7152 * g + 0.0722 * b;
const contrast = (a: number, b: number) => (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);

describe.each(["light", "dark"] as const)("in the %s appearance", (theme) => {
  const token = tokensOf(theme),
    page = luminance(new Color(token("--surface")));
  const steel = { steel: token("--steel-turned"), dark: token("--steel-dark"), light: token("--steel-light") };
  const chuck = chuckTones({
    chuck: token("--chuck"),
    chuckDark: token("--chuck-dark"),
    steelLight: token("--steel-light"),
  });
  const sent = (colour: Color, by: keyof typeof SEEN) => luminance(colour) * SEEN[by];

  test.each(["raw", "rough", "thread", "finished"] as const)(
    "%s steel stands out from the page, however it is turned",
    (texture) => {
      for (const by of ["eye", "light", "away"] as const) {
        expect(contrast(toned(sent(groundOf(texture, steel), by)), page)).toBeGreaterThan(1.2);
      }
    },
  );

  test("workpiece, jaws and chuck differ at the face, and from the page", () => {
    const [raw, finished] = [sent(groundOf("raw", steel), "eye"), toned(sent(groundOf("finished", steel), "eye"))];
    const [body, jaw] = [sent(chuck.chuck, "eye"), sent(chuck.jaw, "eye")];
    for (const [a, b] of [
      [raw, jaw],
      [raw, body],
      [jaw, body],
      [finished, jaw],
      [finished, body],
      [body, page],
      [jaw, page],
    ] as const) {
      expect(contrast(a, b)).toBeGreaterThan(1.15);
    }
  });
});

test("light is toned continuously and monotonically, and never as bright as the page", () => {
  expect(toned(0.317)).toBe(0.317);
  for (let light = 0; light < 3; light += 0.0137) {
    expect(toned(light + 0.0137)).toBeGreaterThan(toned(light));
    expect(toned(light + 0.0137) - toned(light)).toBeLessThan(0.01371);
    expect(toned(light)).toBeLessThan(0.82);
  }
});
