import { Suspense, useEffect, useState } from "react";
import { lazyWithin } from "../../base/parts.ts";
import { drawingSlot, shareSlot } from "../slots.ts";
import { leaving, openStem, type Leaving } from "./ProgramMenus.tsx";
import { takeAnswer } from "../../base/until-gone.ts";

const ShareDialog = lazyWithin(async () => ({ default: await shareSlot.fetch() }));
const ProgramDrawing = lazyWithin(async () => ({ default: await drawingSlot.fetch() }));

/** Shares the open work once it is checked, or asks first. */
function ShareOpen({ done }: { readonly done: () => void }) {
  const [handed, hand] = useState<Leaving | null>(null);
  useEffect(() => takeAnswer(leaving, (made) => (made ? hand(made) : done())), [done]);
  return handed && <ShareDialog {...handed} done={done} />;
}

/** The workshop drawing of the open work, or its share dialog, opened from anywhere. */
export function WorkDialog({ of, done }: { readonly of: "drawing" | "share"; readonly done: () => void }) {
  const [stem] = useState(openStem);
  return (
    <Suspense>{of === "drawing" ? <ProgramDrawing stem={stem} done={done} /> : <ShareOpen done={done} />}</Suspense>
  );
}
