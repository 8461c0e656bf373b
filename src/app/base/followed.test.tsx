import { act, cleanup, render, screen } from "@testing-library/react";
import { memo, startTransition, useLayoutEffect } from "react";
import { flushSync } from "react-dom";
import { afterEach, beforeEach, expect, test } from "vitest";
import { createStore } from "zustand";
import { catchUp, useFollowed } from "./followed.ts";

interface Told {
  readonly a: number;
  readonly b: number;
}

const store = createStore<Told>(() => ({ a: 1, b: 1 }));
let rendered = 0;
const Follower = memo(function Follower({ of }: { readonly of: keyof Told }) {
  rendered += 1;
  return <output>{useFollowed(store, (told) => told[of])}</output>;
});
const shown = () => screen.getByRole("status").textContent;

beforeEach(() => act(() => store.setState({ a: 1, b: 1 })));
afterEach(cleanup);

test("a component follows what it selects, and renders for nothing else", () => {
  render(<Follower of="a" />);
  const before = rendered;
  act(() => store.setState({ b: 7 }));
  expect([shown(), rendered]).toEqual(["1", before]);
  act(() => store.setState({ a: 2.5 }));
  expect(shown()).toBe("2.5");
});

test("what it passed over is known when it selects that", () => {
  const { rerender } = render(<Follower of="a" />);
  act(() => store.setState({ b: 7 }));
  rerender(<Follower of="b" />);
  expect(shown()).toBe("7");
});

test("what was told before it listened is shown", () => {
  const Early = () => {
    useLayoutEffect(() => store.setState({ a: 3.25 }), []);
    return <Follower of="a" />;
  };
  render(<Early />);
  expect(shown()).toBe("3.25");
});

/** Tells something by and by, and looks before that is rendered. */
async function behind(look: () => void): Promise<void> {
  render(<Follower of="a" />);
  startTransition(() => store.setState({ a: 4.75 }));
  look();
  await expect.poll(shown).toBe("4.75");
}

test("what a transition tells is rendered by and by", () => behind(() => expect(shown()).toBe("1")));

test("what is still to be rendered can be had at once", () =>
  behind(() => {
    flushSync(catchUp);
    expect(shown()).toBe("4.75");
  }));

test("what was told last counts, also where it looks like what is shown", async () => {
  render(<Follower of="a" />);
  startTransition(() => store.setState({ a: 4.75 }));
  startTransition(() => store.setState({ a: 1 }));
  startTransition(() => store.setState({ b: 9 }));
  await act(async () => new Promise((done) => setTimeout(done)));
  expect(shown()).toBe("1");
});
