import { useEffect, useEffectEvent, useState } from "react";
import { durationText } from "../../base/clock-text.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { useLengths } from "../../calculation/lengths.ts";
import { useOutcome, type Outcome } from "../../calculation/outcome.ts";
import { useEditor } from "../../document/store.ts";
import { usePlace } from "../../place/place.ts";
import { openText } from "../../document/printed.ts";
import { effectOf } from "./effect.ts";

/** Decimals of a spoken infeed, mm. */
const DECIMALS = 2;

/** Passes, infeed and time in a sentence; a program of several operations has no common infeed. */
function useSentence(): (outcome: Outcome) => string {
  const t = useTexts();
  const lengths = useLengths();
  return (outcome) => {
    const { passes, infeed, seconds } = effectOf(outcome);
    const [count, time] = [
      t.editor.passes(passes),
      durationText(t.page.effect.duration, lengths.language, seconds),
    ] as const;
    const isOne = outcome.run.operations.length === 1 && passes > 0 && infeed > 0;
    return isOne
      ? t.dialog.result(count, `${lengths.number(infeed, DECIMALS)} ${lengths.words("mm")}`, time)
      : `${count}, ${time}`;
  };
}

/** What came of a taken value, for screen readers: once when a prompt is left, never while one types. */
export function SpokenEffect() {
  const [said, say] = useState("");
  const sentence = useSentence();
  const tell = useEffectEvent((outcome: Outcome) => say(sentence(outcome)));
  useEffect(() => {
    /** The text that is announced once it is checked. */
    let taken: string | null = null;
    let told = openText();
    const look = () => {
      const { newest } = useOutcome.getState();
      if (taken === null || newest?.text !== taken) return;
      told = taken;
      taken = null;
      tell(newest);
    };
    const stops = [
      usePlace.subscribe((now, before) => {
        if (now.prompt === before.prompt && now.section === before.section) return;
        const text = openText();
        taken = text === told ? null : text;
        look();
      }),
      useOutcome.subscribe(look),
      useEditor.subscribe((now, before) => {
        if (now.work !== before.work) [told, taken] = [openText(now), null];
      }),
    ];
    return () => {
      for (const stop of stops) stop();
    };
  }, []);
  return (
    <p className="unseen" role="status">
      {said}
    </p>
  );
}
