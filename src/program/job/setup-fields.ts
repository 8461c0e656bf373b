import { anyNumber, type Field } from "../values/field.ts";

const field = (id: string, least: number, optional = false): Field => ({
  ...anyNumber,
  id,
  range: [least, Infinity],
  optional,
});
/** Any positive number. */
const MORE = Number.MIN_VALUE;

/** Number fields of the set-up; each Q parameter has its own, under its name. */
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

/** Field for the value of a Q parameter used in prompts. */
export const parameterField = (name: string): Field => field(`parameter.${name}`, -Infinity);
