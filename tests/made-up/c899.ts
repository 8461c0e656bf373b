import { c812 } from "../../src/cycles/c812.ts";
import { defineCycle } from "../../src/cycles/define.ts";
import { type Setups, shoulderSetups } from "../../src/cycles/random-setup.ts";
import { axial, degrees, length } from "../../src/kernel/units.ts";

const { Q215, Q460, Q491, Q492, Q493, Q494, Q463, Q478, Q483, Q484, Q505, Q506 } = c812.params;
/** Values that a plain shoulder does not have. */
const PLAIN = {
  Q495: degrees(0),
  Q501: 0,
  Q502: length(0),
  Q500: length(0),
  Q496: degrees(0),
  Q503: 0,
  Q504: length(0),
} as const;

/** A cycle of no control: a shoulder with square edges, with its prompts in another order. */
export const c899 = defineCycle({
  ...c812,
  number: 899,
  params: { Q215, Q460, Q492, Q491, Q494, Q493, Q463, Q478, Q483, Q484, Q505, Q506 },
  setup: { ...c812.setup, name: "MADEUP" },
  outline: (v, given) => c812.outline({ ...v, ...PLAIN }, given),
  plan: (v, setting, given) => c812.plan({ ...v, ...PLAIN, Q492: axial(v.Q492) }, setting, given),
});

/** Set-ups without those values. */
export const setups899: Setups = (draw) => {
  const drawn = shoulderSetups(draw);
  if (!drawn) return null;
  return { ...drawn, values: Object.fromEntries(Object.entries(drawn.values).filter(([q]) => q in c899.params)) };
};
