import { lazyPart } from "../../base/parts.ts";

/** Fetched when a time is first shown. */
const TimeParts = lazyPart(async () => ({ default: (await import("./TimeParts.tsx")).TimeParts }));

/** The label of a machining time, with a button to its breakdown. */
export function TimeName({ name }: { readonly name: string }) {
  return (
    <>
      {name}{" "}
      <span className="time-place">
        <TimeParts />
      </span>
    </>
  );
}
