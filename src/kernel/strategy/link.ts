import { staysAbove, type Envelope } from "../reach/envelope.ts";
import type { Flat, FlatSegment, Frame } from "../geometry/flat.ts";
import type { FeedUnit } from "../plan/move.ts";
import { SAME } from "../tolerance.ts";
import { Track, type Purpose, type Room } from "../plan/track.ts";
import type { Frontier } from "./frontier.ts";

/** How a link runs. Lengths mm. */
export interface Link {
  /** Distance kept from what stands while the tool crosses it, and where it comes down on it. */
  readonly gap: number;
  /** Feed wherever material may stand. */
  readonly feed: number;
  /** Steps of the manual that the ways up and across, down at rapid, and down at feed belong to. */
  readonly out: Purpose;
  readonly down: Purpose;
  readonly enter: Purpose;
}

/**
 * A tool at work: its moves, and what still stands in front of it. Everything that runs at feed lowers the frontier.
 */
export class Cutter extends Track {
  private readonly nearest: number;

  constructor(
    frame: Frame,
    feedUnit: FeedUnit,
    start: Flat,
    room: Room,
    readonly frontier: Frontier,
    /** The tool rises no higher than this unless something stands higher. */
    private readonly ceiling: number,
  ) {
    super(frame, feedUnit, start, room);
    this.nearest = room.nearest ?? -Infinity;
  }

  override feed(point: Flat, value: number, purpose: Purpose): void {
    const from = this.at;
    super.feed(point, value, purpose);
    this.frontier.lower({ kind: "line", from, to: this.at });
  }

  override follow(segment: FlatSegment, value: number, purpose: Purpose): void {
    super.follow(segment, value, purpose);
    if (segment.kind === "arc") this.frontier.lower(segment);
  }

  /**
   * From where one cut has ended to where the next begins, the only way that any cycle has: up over what stands,
   * across, and down, one axis at a time. At rapid above the frontier only, the rest at feed.
   */
  link(to: Flat, l: Link): void {
    const barrier = this.frontier.over(this.at.u, to.u);
    const over = barrier > this.at.v + SAME ? Math.max(barrier, Math.min(barrier + l.gap, this.ceiling)) : -Infinity;
    const height = Math.max(this.at.v, to.v, over);
    const free = this.frontier.freeFrom(this.at.u) <= this.at.v + SAME;
    // Beside a wall the way back is free at once, the way up is not.
    if (free || !this.frontier.clear(this.at.u, to.u, this.at.v)) this.up(height, l);
    if (this.frontier.clear(this.at.u, to.u, this.at.v)) this.rapid("u", to.u, l.out);
    else this.feed({ u: to.u, v: this.at.v }, l.feed, l.out);
    if (to.v > this.at.v) this.up(to.v, l);
    else this.down(to.v, l);
  }

  private up(height: number, l: Link) {
    if (height <= this.at.v + SAME) return;
    const free = Math.min(height, this.frontier.freeFrom(this.at.u));
    if (free > this.at.v + SAME) this.feed({ u: this.at.u, v: free }, l.feed, l.out);
    this.rapid("v", height, l.out);
  }

  private down(height: number, l: Link) {
    const free = this.frontier.freeFrom(this.at.u);
    this.rapid("v", Math.min(this.at.v, Math.max(height, free + l.gap)), l.down);
    this.feed({ u: this.at.u, v: height }, l.feed, l.enter);
  }

  /**
   * Leaves the contour at feed: at 45°, away from the cutting direction (`towards` −1) or along it (1), by `by` mm in
   * either axis; straight up by the same where the part is in the way. `room`: how far it may lean.
   */
  leave(by: number, towards: 1 | -1, part: Envelope, value: number, purpose: Purpose, room = by): void {
    const lift = this.inBore({ u: this.at.u, v: this.at.v + by }).v - this.at.v;
    const leaning = this.inBore({ u: this.at.u + towards * Math.max(0, Math.min(lift, room)), v: this.at.v + lift });
    this.feed(
      lift > 0 && staysAbove(part, leaning, this.at) ? leaning : { u: this.at.u, v: this.at.v + lift },
      value,
      purpose,
    );
  }

  /**
   * In a bore nothing but a cut leads nearer to the axis than the start point: what stands on the other side meets the
   * insert and its holder. The place next to a point that keeps to that, and comes no nearer than `cut` does; outside
   * the point itself.
   */
  inBore({ u, v }: Flat, cut: Flat = this.at): Flat {
    const { transverse, signV } = this.frame;
    if (transverse) return { u: Math.max(u, Math.min(this.nearest, cut.u)), v };
    return { u, v: signV < 0 ? Math.min(v, Math.max(this.ceiling, cut.v)) : v };
  }
}
