import { create } from "zustand";
import { z } from "zod/mini";
import { parseAddress } from "../place/address.ts";
import { time } from "../base/clock.ts";
import { keptData } from "../base/kept.ts";
import { isMissing } from "../base/parts.ts";

/**
 * A fault of the page, as it is kept on this device. Nothing of it goes anywhere by itself, and no program is in it.
 */
const shape = z.object({
  /** Milliseconds since 1970, of the last time. */
  at: z.number(),
  count: z.number(),
  message: z.string(),
  stack: z.string(),
  version: z.string(),
  /** Address of the page, without what a share link carries. */
  address: z.string(),
  browser: z.string(),
});
export type FaultReport = Readonly<z.output<typeof shape>>;

/** Reports that are kept, and characters of one part of them. */
const MOST = { reports: 8, text: 4000 };

const KEPT = keptData<readonly FaultReport[]>("reports", z.array(shape));

/** Newest first. */
export const useReports = create<{ readonly list: readonly FaultReport[] }>(() => ({
  list: KEPT.get()?.slice(0, MOST.reports) ?? [],
}));

function keep(list: readonly FaultReport[]): void {
  useReports.setState({ list });
  KEPT.set(list.length > 0 ? list : null);
}

/** The address of the page without a program in it: a share link carries one behind its mark. */
export function plainAddress({ pathname, search, hash }: Pick<Location, "pathname" | "search" | "hash">): string {
  const place = hash === "" || parseAddress(hash) ? hash : `${hash.slice(0, 3)}…`;
  return `${pathname}${search}${place}`;
}

/** Said by browsers when a size changes twice in one frame, and by pages of other origins: no fault of the page. */
const NOISE = /^ResizeObserver loop|^Script error\.?$/;

/** Notes a fault. The same one again counts up. */
export function noteFault(error: unknown, where = ""): void {
  const message = (error instanceof Error ? `${error.name}: ${error.message}` : String(error)).slice(0, MOST.text);
  if (NOISE.test(message.replace(/^Error: /, "")) || isMissing(error)) return;
  const stack = `${error instanceof Error ? (error.stack ?? "") : ""}${where}`.slice(0, MOST.text);
  const [last, ...others] = useReports.getState().list;
  const again = last?.message === message;
  const made = {
    at: time(),
    count: again ? last.count + 1 : 1,
    message,
    stack: again && last.stack.length > stack.length ? last.stack : stack,
    version: String(import.meta.env["VITE_VERSION"] ?? ""),
    address: plainAddress(location),
    browser: navigator.userAgent,
  };
  keep([made, ...(again ? others : last ? [last, ...others] : [])].slice(0, MOST.reports));
}

export const forgetReports = (): void => keep([]);

/** A report as text, for whoever mends the page. `program` goes along only where the operator wants it. */
export function reportText(report: FaultReport, program: string | null): string {
  const { at, count, message, stack, version, address, browser } = report;
  const head = `Turnwise ${version}, ${new Date(at).toISOString()}, ${count}×\n${address}\n${browser}\n\n${message}`;
  return `${head}\n${stack}\n${program === null ? "" : `\n${program}\n`}`;
}

/** From now on faults that nothing caught are noted. */
export function startReports(): () => void {
  const onError = (event: ErrorEvent) => noteFault(event.error ?? event.message);
  const onRejection = (event: PromiseRejectionEvent) => noteFault(event.reason);
  addEventListener("error", onError);
  addEventListener("unhandledrejection", onRejection);
  return () => {
    removeEventListener("error", onError);
    removeEventListener("unhandledrejection", onRejection);
  };
}
