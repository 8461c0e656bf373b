import { markdownTable } from "../performance-page.ts";
import { REFERENCE } from "../reference.ts";
import type { FrameResult, KeyResult, ScreenResults } from "./measure-work.ts";
import type { Screen } from "./screens.ts";

const percent = (part: number) => `${Math.round(part * 100)} %`;
const missed = (limit: string, isKept: boolean) => (isKept ? limit : `${limit}, missed`);

/** The limit of frames: a share of the empty page's, or frames per second; none for unusually large programs. */
function frameLimit(screen: Screen, name: string, { share, perSecond }: FrameResult): string {
  if (!/^(flange|812) \d+x$/.test(name)) return "";
  if (screen.perSecond !== null) return missed(`${screen.perSecond} a second`, perSecond >= screen.perSecond);
  return screen.share === null ? "" : missed(percent(screen.share), share >= screen.share);
}

const longTasks = ({ long, longest }: { readonly long: number; readonly longest: number }) =>
  long === 0 ? "0" : `${long} (${longest})`;

const frameRow = (screen: Screen, name: string, each: FrameResult, limit: string): string[] => [
  screen.name,
  name,
  each.empty.toFixed(1),
  each.perSecond.toFixed(1),
  percent(each.share),
  limit,
  each.p95.toFixed(0),
  each.worst.toFixed(0),
  longTasks(each),
];

/** Frames while something moves, compared with the empty page. */
export function frameTable(results: readonly ScreenResults[]): string[] {
  const rows = results.flatMap(({ screen, box, frames }) => [
    ...(box ? [frameRow(screen, "moving box", box, "")] : []),
    ...Object.entries(frames).map(([name, each]) => frameRow(screen, name, each, frameLimit(screen, name, each))),
  ]);
  if (rows.length === 0) return [];
  return [
    "",
    ...markdownTable(
      2,
      ["frames", "", "empty /s", "/s", "share", "limit", "p95 ms", "worst ms", "tasks > 50 ms"],
      rows,
    ),
  ];
}

/**
 * Part of the time to the path is spent waiting for the next screen refresh, which no faster machine shortens. So the
 * limit applies in ms, or as a ratio where the machine is slower than the reference machine.
 */
function keyRow(screen: Screen, name: string, { reference, digit, path, picture, long, longest }: KeyResult): string[] {
  const times = [digit.median, path.median, path.p95, picture.median, picture.p95].map((time) => time.toFixed(0));
  const ratios = [path.median, picture.median].map((time) => (time / reference).toFixed(1));
  const most = screen.key / (REFERENCE * screen.slower),
    limit = `${most.toFixed(1)} = ${screen.key} ms`;
  return [
    screen.name,
    name,
    ...times,
    reference.toFixed(1),
    ...ratios,
    missed(limit, path.median <= screen.key || path.median / reference <= most),
    longTasks({ long, longest }),
  ];
}

/** From a key to the drawing; ratios are in units of the reference loop in the same page. */
export function keyTable(results: readonly ScreenResults[]): string[] {
  const rows = results.flatMap(({ screen, keys }) =>
    Object.entries(keys).map(([name, each]) => keyRow(screen, name, each)),
  );
  if (rows.length === 0) return [];
  return [
    "",
    ...markdownTable(
      2,
      [
        "from a key",
        "",
        "digit ms",
        "path ms",
        "p95",
        "stock ms",
        "p95",
        "reference ms",
        "path ratio",
        "stock ratio",
        "limit of path",
        "tasks > 50 ms",
      ],
      rows,
    ),
  ];
}
