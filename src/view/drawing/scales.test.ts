import * as fc from "fast-check";
import { expect, test } from "vitest";
import { DRAWING_SCALES, factorOf, fillingScale, usualScale } from "./scales.ts";

const room = { wide: 101.5, tall: 63.2 };

test.each([
  [{ wide: 137, tall: 122 }, "1:2"],
  [{ wide: 100.9, tall: 63.1 }, "1:1"],
  [{ wide: 101.6, tall: 12 }, "1:2"],
  [
    {
      wide: 9.7,
      tall: 12.6,
    },
    "5:1",
  ],
  [{ wide: 1730, tall: 88 }, "1:20"],
])("%o is drawn %s", (thing, name) => {
  const { paper, part } = usualScale(thing, room);
  expect(`${paper}:${part}`).toBe(name);
});

test("every size is drawn as large as a usual scale allows", () => {
  const size = fc.double({ min: 0.9, max: 20_000, noNaN: true });
  fc.assert(
    fc.property(size, size, (wide, tall) => {
      const scale = usualScale({ wide, tall }, room);
      const fits = (factor: number) => wide * factor <= room.wide && tall * factor <= room.tall;
      const larger = DRAWING_SCALES.filter((other) => factorOf(other) > factorOf(scale));
      return fits(factorOf(scale)) && !larger.some((other) => fits(factorOf(other)));
    }),
  );
});

test("on a screen a thing fills its room in one direction, and fits in the other", () => {
  const size = fc.double({ min: 0.9, max: 20_000, noNaN: true });
  fc.assert(
    fc.property(size, size, (wide, tall) => {
      const factor = factorOf(fillingScale({ wide, tall }, room));
      const used = Math.max((wide * factor) / room.wide, (tall * factor) / room.tall);
      expect(used).toBeCloseTo(1, 6);
    }),
  );
  // No room at all: as small as a drawing becomes.
  expect(fillingScale({ wide: 10, tall: 10 }, { wide: 50, tall: -3 })).toEqual({ paper: 1, part: 1000 });
});
