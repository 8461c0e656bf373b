import { expect, test } from "vitest";
import { lightness, mixed, shadeStops, steelAt } from "./shade.ts";
import type { Texture } from "./surfaces.ts";

const across = Array.from({ length: 101 }, (_, i) => i / 100);
const brightest = (texture: Texture) =>
  across.reduce((best, u) => (lightness(u, 0, texture, "lit") > lightness(best, 0, texture, "lit") ? u : best), 0);

test("a cylinder is darkest at its edge, and brightest at a third", () => {
  for (const texture of ["rough", "finished"] as const) {
    expect(brightest(texture)).toBeCloseTo(1 / 3, 1);
    expect(Math.min(...across.map((u) => lightness(u, 0, texture, "lit")))).toBe(lightness(1, 0, texture, "lit"));
  }
});

test("finished surfaces are lighter than rough ones, and those than raw ones", () => {
  for (const u of [0.02, 0.33, 0.71]) {
    const [raw, rough, finished] = (["raw", "rough", "finished"] as const).map((texture) =>
      lightness(u, 0, texture, "lit"),
    ) as [number, number, number];
    expect(raw).toBeLessThan(rough);
    expect(rough).toBeLessThan(finished);
  }
});

test("cones differ by the direction they face, a hole is dark where it is deep, and halves meet without a step", () => {
  const at = (degrees: number) => lightness(0.5, (degrees * Math.PI) / 180, "rough", "lit");
  expect(at(-41)).toBeLessThan(at(0) - 0.05);
  expect(Math.abs(at(27) - at(-27))).toBeGreaterThan(0.1);
  expect(lightness(0.1, 0, "finished", "hole")).toBeLessThan(lightness(0.9, 0, "finished", "hole"));
  expect(lightness(0, 0.3, "finished", "lit")).toBeCloseTo(lightness(0, 0.3, "finished", "away"), 12);
});

test("colours are mixed channel by channel", () => {
  expect(mixed("#102030", "#30a0f0", 0.25)).toBe("#184060");
  expect(steelAt({ dark: "#000000", base: "#808080", light: "#ffffff" }, 0.25)).toBe("#404040");
  const stops = shadeStops({ dark: "#000000", base: "#808080", light: "#ffffff" }, 0, "raw", "lit");
  expect(stops.map(([u]) => u)).toEqual([...stops.map(([u]) => u)].sort((a, b) => a - b));
  expect([stops[0]?.[0], stops.at(-1)?.[0]]).toEqual([0, 1]);
});
