import { create } from "zustand";
import { z } from "zod/mini";
import { amount, moment } from "../../program/files/bounded.ts";
import { parseAddress } from "../place/address.ts";
import { time } from "../base/clock.ts";
import { storedData } from "../base/storage.ts";
import { isMissing } from "../base/parts.ts";

/** A fault of the page, stored on this device. It is never sent by itself, and contains no program. */
const shape = z.object({
  /** Milliseconds since 1970, of the last time. */
  at: moment,
  count: amount,
  message: z.string(),
  stack: z.string(),
  version: z.string(),
  /** Address of the page, without what a share link carries. */
  address: z.string(),
  browser: z.string(),
});
export type FaultReport = Readonly<z.output<typeof shape>>;

/** Most reports, and characters of one field. */
const MOST = { reports: 8, text: 4000 };

const KEPT = storedData<readonly FaultReport[]>("reports", z.array(shape));

/** Newest first. */
export const useReports = create<{ readonly list: readonly FaultReport[] }>(() => ({
  list: KEPT.get()?.slice(0, MOST.reports) ?? [],
}));

function keep(list: readonly FaultReport[]): void {
  useReports.setState({ list });
  KEPT.set(list.length > 0 ? list : null);
}

/** The page address without the program of a share link. */
export function plainAddress({ pathname, search, hash }: Pick<Location, "pathname" | "search" | "hash">): string {
  const place = hash === "" || parseAddress(hash) ? hash : `${hash.slice(0, 3)}…`;
  return `${pathname}${search}${place}`;
}

/** Messages that are no fault of the page: a size that changes twice in one frame, scripts of other origins. */
const NOISE = /^ResizeObserver loop|^Script error\.?$/;

/** Records a fault. A repeated one increments its count. */
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

/** A report as text. `program` is included only if the operator wants it. */
export function reportText(report: FaultReport, program: string | null): string {
  const { at, count, message, stack, version, address, browser } = report;
  const head = `Turnwise ${version}, ${new Date(at).toISOString()}, ${count}×\n${address}\n${browser}\n\n${message}`;
  return `${head}\n${stack}\n${program === null ? "" : `\n${program}\n`}`;
}

/** Starts recording uncaught faults. */
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
