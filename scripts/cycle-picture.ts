import type { Cycle } from "../src/cycles/define.ts";
import { pointPlan } from "../src/cycles/point-plan.ts";
import { texts } from "../src/i18n/index.ts";
import { formatNumber } from "../src/i18n/number.ts";
import { at } from "../src/kernel/geometry/point.ts";
import { diameter, toRadius } from "../src/kernel/units.ts";
import { readRows } from "../src/program/job/contour-rows.ts";
import { exampleJob } from "../src/program/job/job.ts";
import { exampleDraft, readDraft } from "../src/program/job/read-draft.ts";
import { helpDrawing } from "../src/view/help/picture.ts";
import { helpSvg } from "../src/view/help/svg.ts";
import { helpRules, styled } from "./page-colours.ts";

const SIZE = { width: 520, height: 340 };

/** Hatches of the part and of the machined area, as on the page. */
const HATCHES = [
  ["part", 7, 45],
  ["cut", 5, -45],
]
  .map(
    ([name, size, turn]) =>
      `<pattern id="hatch-${name}" width="${size}" height="${size}" patternUnits="userSpaceOnUse" patternTransform="rotate(${turn})">` +
      `<rect class="hatch-ground" width="${size}" height="${size}"/><path class="hatch-${name}" d="M0.5 0V${size}"/></pattern>`,
  )
  .join("");

/** The help picture of a cycle's example, without colours of its own; null for a cycle that cuts nothing. */
export function cyclePicture(cycle: Cycle): string | null {
  const job = exampleJob(cycle);
  const { values } = readDraft(cycle, exampleDraft(cycle));
  if (cycle.acts || !values) return null;
  const given = {
    contour: cycle.contour === "free" ? readRows(job.contour).contour.segments : null,
    start: at(Number(job.start.z), toRadius(diameter(Number(job.start.x)))),
  };
  const outline = cycle.outline(values, given);
  if (outline.contour.length === 0) return null;
  const { help } = texts("en");
  const drawing = helpDrawing({
    params: cycle.params,
    values: values as Parameters<typeof helpDrawing>[0]["values"],
    outline,
    plan: pointPlan(cycle, values, outline, given),
    active: null,
    size: SIZE,
    speech: {
      number: (value, decimals) => formatNumber("en", value, decimals),
      element: [help.element.none, help.element.chamfer, help.element.radius],
      reserved: help.reserved,
      notToScale: help.notToScale,
    },
  });
  return helpSvg(drawing)
    .replace("<svg ", `<svg class="help-picture" role="img" aria-label="${help.picture(String(cycle.number))}" `)
    .replaceAll(/data-lens="(\S+) (\S+) (\S+)"/g, 'style="clip-path: circle($3px at $1px $2px)"');
}

/** The style of such pictures; their figures are laid out for a fixed-width font. */
export const pictureRules = (): string =>
  [
    helpRules(),
    ".help-picture { font-family: var(--number-font); }",
    ".help-picture .fill-part { fill: url(#hatch-part); }",
    ".help-picture .fill-cut { fill: url(#hatch-cut); }",
  ].join("\n");
/** The hatches that all pictures share. */
export const pictureHatches = (): string => `<defs>${HATCHES}</defs>`;

/** The picture as a separate file, light or dark as the system is. */
export function cycleSvg(cycle: Cycle): string | null {
  const drawn = cyclePicture(cycle);
  const head = drawn?.indexOf(">") ?? 0;
  if (!drawn) return null;
  const ground = `<rect width="100%" height="100%" style="fill: var(--surface)"/>`;
  return `${drawn.slice(0, head + 1)}\n  <style>${styled(pictureRules())}</style>\n  ${pictureHatches()}\n  ${ground}${drawn.slice(
    head + 1,
  )}`;
}
