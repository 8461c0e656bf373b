import { stopwatch } from "../base/clock.ts";
import { retryImport } from "../base/parts.ts";
import { sourceFields, type Executor, type Order, type Text } from "./orders.ts";
import type { planned, planner } from "./plan.ts";

/** The first share of a text, in whole lines. */
function shareOf(request: Text, share: number): Text {
  const end = request.text.indexOf("\n", share * (request.text.length - 1));
  return end < 0 ? request : { ...request, text: request.text.slice(0, end + 1) };
}

/** Plans on the page, in the task of the order. The planning code is fetched first. */
export function pageExecutor(): { readonly execute: Executor<Order & { do: "plan" }>; fetch(): Promise<void> } {
  let code: { readonly plan: ReturnType<typeof planner>; readonly planAlone: typeof planned } | null = null;
  const make = ({ request, part }: Order & { do: "plan" }) => {
    if (!code) return null;
    if (part === "whole") return code.plan(request);
    // A share is planned without the cache, as long as an unknown program takes.
    if ("share" in part) return code.planAlone(shareOf(request, part.share));
    const begun = stopwatch();
    return code.plan.part(request, () => stopwatch() - begun < part.slice) ?? "part";
  };
  return {
    async fetch() {
      const { planner, planned } = await retryImport(() => import("./plan.ts"));
      code = { plan: planner(), planAlone: planned };
    },
    execute(order, tell) {
      const begun = stopwatch();
      const { version } = order.request;
      let made: ReturnType<typeof make> = null;
      try {
        made = make(order);
        if (made && made !== "part") made = { ...made, ...sourceFields(order.request) };
      } catch {
        // The worker fails the same way and reports it.
      }
      tell({ event: "planned", version, made, took: stopwatch() - begun });
    },
  };
}
