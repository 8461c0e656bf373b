import { noseRadius } from "../../kernel/cutter/insert.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { rounded } from "../../kernel/units.ts";
import type { Job, SetJob } from "../../program/job/job.ts";

/** Prompts and fields of the set-up with a page in the guide, in the order of the set-up. */
export const SETUP_PAGES = [
  "blank.outside",
  "blank.bore",
  "blank.length",
  "blank.allowance",
  "tool",
  "start.x",
  "start.z",
  "spindle.cuttingSpeed",
  "spindle.limit",
  "spindle.speed",
  "perRevolution",
  "rapid",
] as const;
export type SetupPageId = (typeof SETUP_PAGES)[number];
export const isSetupPage = (id: string): id is SetupPageId => SETUP_PAGES.some((page) => page === id);

/** A work with another value at one place of its set-up. */
export interface SetupVariant {
  readonly value: number;
  readonly isUsual: boolean;
  readonly job: SetJob;
}

type Numbered = Exclude<SetupPageId, "tool" | "perRevolution">;

const textAt = ({ blank, start, spindle, rapid }: SetJob, id: Numbered): string =>
  ({
    "blank.outside": blank.outside,
    "blank.bore": blank.bore,
    "blank.length": blank.length,
    "blank.allowance": blank.allowance,
    "start.x": start.x,
    "start.z": start.z,
    "spindle.cuttingSpeed": spindle.cuttingSpeed,
    "spindle.limit": spindle.limit,
    "spindle.speed": spindle.speed,
    rapid,
  })[id];

/** The job with another value at a place; a speed that does not match the spindle mode brings its own mode. */
export function withSetupValue<J extends Job>(job: J, id: SetupPageId, value: number): J {
  const text = String(value);
  const [part, field = ""] = id.split(".");
  if (id === "tool") return { ...job, tool: value };
  if (id === "perRevolution") return { ...job, perRevolution: value !== 0 };
  if (part === "blank") return { ...job, blank: { ...job.blank, [field]: text } };
  if (part === "start") return { ...job, start: { ...job.start, [field]: text } };
  if (id === "rapid") return { ...job, rapid: text };
  return { ...job, spindle: { ...job.spindle, mode: id === "spindle.speed" ? "constant" : "surface", [field]: text } };
}

/** A smaller and a larger value than the default: offsets in mm for blank and start, factors elsewhere. */
function smallerAndLarger(id: Numbered, usual: number, job: SetJob): readonly [number, number] {
  switch (id) {
    case "blank.outside":
      return [usual - 6, usual + 20];
    case "blank.bore":
      return usual > 0 ? [0, usual * 1.2] : [Number(job.blank.outside) * 0.3, Number(job.blank.outside) * 0.6];
    case "blank.length":
      return [usual * 0.8, usual * 1.3];
    case "blank.allowance":
      return [usual + 2, usual + 5];
    case "start.x":
    case "start.z":
      return [usual + 5, usual + 30];
    case "spindle.limit":
      return [usual * 0.4, usual * 2];
    default:
      return [usual * 0.5, usual * 2];
  }
}

/**
 * Tools to compare with: of the same kind and orientation, with the nearest smaller and the nearest larger nose radius,
 * else the next ones.
 */
export function comparableTools(tools: readonly Tool[], own: Tool): readonly Tool[] {
  const kin = tools.filter(({ T, TYPE, TO }) => T !== own.T && TYPE === own.TYPE && TO === own.TO);
  const by = kin.toSorted((a, b) => noseRadius(a) - noseRadius(b));
  const smaller = by.findLast((tool) => noseRadius(tool) < noseRadius(own)),
    larger = by.find((tool) => noseRadius(tool) > noseRadius(own));
  const chosen = [smaller, larger].filter((tool) => tool !== undefined);
  const others = [...kin, ...tools].filter(
    ({ T, TO }) => T !== own.T && TO === own.TO && !chosen.some((tool) => tool.T === T),
  );
  return [...chosen, ...others.slice(0, 2 - chosen.length)];
}

/** A job at a small, the default and a large value of a place; other tools for the called one; M136 on and off. */
export function setupVariants(id: SetupPageId, job: SetJob, tools: readonly Tool[]): readonly SetupVariant[] {
  if (id === "perRevolution")
    return [true, false].map((on) => ({
      value: Number(on),
      isUsual: on === job.perRevolution,
      job: withSetupValue(job, id, Number(on)),
    }));
  if (id === "tool") {
    const own = tools.find(({ T }) => T === job.tool);
    if (!own) return [];
    const all = [own, ...comparableTools(tools, own)].toSorted((a, b) => noseRadius(a) - noseRadius(b));
    return all.map(({ T }) => ({ value: T, isUsual: T === own.T, job: withSetupValue(job, id, T) }));
  }
  const usual = Number(textAt(job, id));
  if (!Number.isFinite(usual)) return [];
  const values = [usual, ...smallerAndLarger(id, usual, job).map((n) => rounded(Number(n.toFixed(1))))];
  return [...new Set(values)]
    .toSorted((a, b) => a - b)
    .map((value) => ({
      value,
      isUsual: value === usual,
      job: withSetupValue(job, id, value),
    }));
}
