import { issue, type Issue } from "../plan/issue.ts";
import { SAME } from "../tolerance.ts";
import { roundedDown } from "../units.ts";

/** Shortening by the control of each recess-turning pass from the second on, mm (manual, recess turning). */
export const CONTROL_OFFSET = 0.1;
/** The sum on one side may reach this share of the effective edge width (manual, recess turning). */
const SHARE = 0.8;

/**
 * Shortening per pass, mm. It adds up on the side where passes end: every second one, or every one if they all run the
 * same way. A programmed value is lowered to the largest that fits, with a message; the control's own 0.1 is not, and
 * is an error when its sum exceeds the limit (the plan then uses the largest that fits).
 */
export function offsetPerPass(
  programmed: number,
  passes: number,
  oneWay: boolean,
  effectiveWidth: number,
  issues: Issue[],
): number {
  const times = oneWay ? passes - 1 : Math.ceil((passes - 1) / 2);
  if (times <= 0) return 0;
  const max = SHARE * effectiveWidth;
  const most = max / times;
  const asked = programmed > 0 ? programmed : CONTROL_OFFSET;
  if (asked <= most + SAME / times) return asked;
  const nearest = roundedDown(most);
  issues.push(
    programmed > 0
      ? issue("offsetReduced", "warning", { offset: programmed, kept: nearest, nearest, passes }, "offset")
      : issue("offsetOverLimit", "error", { offset: asked * times, max, passes, nearest }, "offset"),
  );
  return most;
}
