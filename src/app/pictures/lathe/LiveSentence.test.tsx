import { act, cleanup, render, screen } from "@testing-library/react";
import { afterEach, expect, test } from "vitest";
import { trackOf } from "../../../view/playback.ts";
import { manualClock } from "../../base/clock.ts";
import { createPlaybackStore } from "../../calculation/playback-store.ts";
import { LiveSentence } from "./LiveSentence.tsx";

afterEach(cleanup);

test("the moment is announced in its own view and while it plays, not where it follows other input", () => {
  const clock = manualClock();
  const playback = createPlaybackStore(clock);
  playback.dispatch({ do: "load", track: trackOf([{ seconds: 10 }, { seconds: 10 }, { seconds: 10 }]) });
  const sentence = () => `move ${playback.get().position.step}`;
  render(
    <>
      <input aria-label="elsewhere" />
      <section>
        <button type="button">next</button>
        <LiveSentence playback={playback} clock={clock} sentence={sentence} />
      </section>
    </>,
  );
  const said = () => screen.getByRole("status").textContent;
  const seek = (step: number) => act(() => playback.dispatch({ do: "seek", position: { step, fraction: 0 } }));
  expect(said()).toBe("");
  screen.getByRole("textbox").focus();
  seek(1);
  expect(said()).toBe("");
  screen.getByRole("button").focus();
  seek(2);
  expect(said()).toBe("move 2");
  screen.getByRole("textbox").focus();
  seek(0);
  act(() => playback.dispatch({ do: "play" }));
  expect(said()).toBe("move 2");
  act(() => clock.advance(3000));
  expect(said()).toBe("move 0");
});
