import { Suspense } from "react";
import { lazyPart } from "../../base/parts.ts";

/** Fetched when a time is first shown. */
const TimeParts = lazyPart(async () => ({ default: (await import("./TimeParts.tsx")).TimeParts }));

/** What a running time is called, with the way to what it is made of. */
export function TimeName({ name }: { readonly name: string }) {
  return (
    <>
      {name}{" "}
      <Suspense>
        <TimeParts />
      </Suspense>
    </>
  );
}
