import type { Job } from "./job.ts";
import type { SetupPlace } from "./setup-places.ts";

/** Text of a set-up field; empty if it is not set. */
export function typedAt({ tool, blank, start }: Pick<Job, "tool" | "blank" | "start">, place: SetupPlace): string {
  const texts: Readonly<Record<SetupPlace, string>> = {
    tool: tool === null ? "" : String(tool),
    "blank.outside": blank.outside,
    "blank.bore": blank.bore,
    "blank.length": blank.length,
    "blank.allowance": blank.allowance,
    "start.x": start.x,
    "start.z": start.z,
  };
  return texts[place];
}

/** The job with another text in a set-up field; empty: it is proposed. A tool that is no number changes nothing. */
export function withPlace(job: Job, place: SetupPlace, text: string): Job {
  if (text === typedAt(job, place)) return job;
  if (place === "tool") {
    const number = text.trim();
    return /^\d{0,5}$/.test(number) ? { ...job, tool: number === "" ? null : Number(number) } : job;
  }
  if (place === "start.x") return { ...job, start: { ...job.start, x: text } };
  if (place === "start.z") return { ...job, start: { ...job.start, z: text } };
  return { ...job, blank: { ...job.blank, [place.slice("blank.".length)]: text } };
}
