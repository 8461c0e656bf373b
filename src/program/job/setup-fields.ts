import { anyNumber, type Field } from "../values/field.ts";

const field = (id: string, least: number, optional = false): Field => ({
  ...anyNumber,
  id,
  range: [least, Infinity],
  optional,
});
/** Anything above nothing. */
const MORE = Number.MIN_VALUE;

/** The numbers of the set-up; a Q parameter has its own under its name. */
export const SETUP_FIELDS = {
  startX: field("start.x", -Infinity),
  startZ: field("start.z", -Infinity),
  outside: field("blank.outside", MORE),
  bore: field("blank.bore", 0, true),
  length: field("blank.length", MORE),
  allowance: field("blank.allowance", -Infinity, true),
  speed: field("spindle.speed", MORE),
  cuttingSpeed: field("spindle.cuttingSpeed", MORE),
  limit: field("spindle.limit", MORE),
  rapid: field("rapid", MORE),
} as const;

/** The value of a Q parameter that stands in prompts. */
export const parameterField = (name: string): Field => field(`parameter.${name}`, -Infinity);
