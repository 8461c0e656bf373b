import { useCallback, useEffect, useRef, useState } from "react";
import { Icon } from "../../app/base/Icon.tsx";
import { scheduleIdle } from "../../app/base/idle.ts";
import { takeAnswer } from "../../app/base/until-gone.ts";
import { lazyPart, retryImport } from "../../app/base/parts.ts";
import { reducedMotion } from "../../app/base/settings/appearance.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { fetchShownTexts, useTexts } from "../../app/base/settings/use-texts.ts";
import { useTheme } from "../../app/base/use-theme-colours.ts";
import { openText } from "../../app/fields/open/open-program.ts";
import type { HeroProgram, Theme } from "./pictures.ts";
import type { RunningPass } from "./running-pass.ts";
import type { ViewBox } from "../../view/thumbnail.ts";
import "./hero.css";

const LivePicture = lazyPart(async () => {
  const [part] = await Promise.all([import("./LivePicture.tsx"), fetchShownTexts()]);
  return { default: part.LivePicture };
});

const DRAWINGS = {
  light: () => import("virtual:start-pictures/light"),
  dark: () => import("virtual:start-pictures/dark"),
} as const satisfies Record<Theme, unknown>;

/** The lathe view before its program has run, drawn by the build. */
function Still({ box }: { readonly box: ViewBox }) {
  useTheme();
  const theme: Theme = document.documentElement.dataset["theme"] === "dark" ? "dark" : "light";
  const [drawing, take] = useState("");
  useEffect(
    () =>
      takeAnswer(
        () => Promise.all([DRAWINGS[theme](), import("../../app/pictures/lathe/lathe.css")]).catch(() => null),
        (made) => made && take(made[0].drawing),
        // After the first paint: its place is reserved.
        scheduleIdle,
      ),
    [theme],
  );
  return (
    <svg
      className="hero-still"
      viewBox={box.join(" ")}
      aria-hidden="true"
      dangerouslySetInnerHTML={{ __html: drawing }}
    />
  );
}

/** Opens the played program. */
async function openPlayed(): Promise<void> {
  openText((await retryImport(() => import("virtual:start-pictures/program"))).text);
}

/** Whether an element is on the screen of a page that is shown. */
function useSeen(element: { readonly current: Element | null }): boolean {
  const [inView, setInView] = useState(true);
  const [isPageSeen, setPageSeen] = useState(!document.hidden);
  useEffect(() => {
    const onSeen = () => setPageSeen(!document.hidden);
    document.addEventListener("visibilitychange", onSeen);
    return () => document.removeEventListener("visibilitychange", onSeen);
  }, []);
  useEffect(() => {
    if (!element.current || typeof IntersectionObserver === "undefined") return undefined;
    const observer = new IntersectionObserver((entries) => setInView(entries.at(-1)?.isIntersecting ?? true));
    observer.observe(element.current);
    return () => observer.disconnect();
  }, [element]);
  return inView && isPageSeen;
}

/**
 * A real program on the lathe view: the tool moves and removes material. A still picture of the build stands there
 * until the view has loaded, and for good with reduced motion, unless the operator plays it. Out of sight it pauses.
 */
export function Hero({ of }: { readonly of: HeroProgram | undefined }) {
  const {
    page: { effect },
    start: { hero: t },
    menu,
  } = useTexts("first");
  const motionless = useSettings(reducedMotion);
  const [chosen, choose] = useState<boolean | null>(null);
  const [ready, setReady] = useState(false);
  const [now, say] = useState<RunningPass | null>(null);
  const figure = useRef<HTMLElement>(null);
  const seen = useSeen(figure);
  const asked = chosen ?? !motionless;
  useEffect(() => (ready || !asked ? undefined : scheduleIdle(() => setReady(true))), [ready, asked]);
  const onRunning = useCallback((next: RunningPass) => say(next), []);

  const running = now ?? of?.running;
  const doing =
    running && (running.pass > 0 ? t.pass(running.pass, running.passes) : t[running.pass < 0 ? "finish" : "position"]);
  const seconds = String((of?.seconds ?? 0) % 60).padStart(2, "0");
  return (
    <figure ref={figure} className={`hero${now ? " live" : ""}`}>
      <div className="hero-stage">
        {of && (
          <>
            <Still box={of.box} />
            {ready && (
              <LivePicture hero={of} plays={asked && seen} name={t.name(of.operations)} onRunning={onRunning} />
            )}
          </>
        )}
      </div>
      <figcaption>
        {of && running && (
          <>
            <button
              type="button"
              className="button icon plain"
              aria-label={asked ? t.pause : t.play}
              title={asked ? t.pause : t.play}
              onClick={() => choose(!asked)}
            >
              <Icon name={asked ? "pause" : "play"} />
            </button>
            <span className="hero-doing">
              <b className="number card-number">{running.cycle}</b> {menu.of[running.cycle]?.name}, {doing}
            </span>
            <span className="hero-facts small soft">
              {t.facts(of.operations, of.tools)} · {effect.duration(Math.floor(of.seconds / 60), seconds)}
              {of.proved && (
                <span className="hero-proved">
                  <Icon name="check" /> {t.proved}
                </span>
              )}
            </span>
            <button type="button" className="button plain hero-open" onClick={() => void openPlayed()}>
              {t.open} <Icon name="fold" />
            </button>
          </>
        )}
      </figcaption>
    </figure>
  );
}
