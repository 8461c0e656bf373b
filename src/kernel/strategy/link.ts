import { staysAbove, type Envelope } from "../reach/envelope.ts";
import type { Flat, FlatSegment, Frame } from "../geometry/flat.ts";
import type { FeedUnit } from "../plan/move.ts";
import { SAME } from "../tolerance.ts";
import { Track, type Purpose, type Room } from "../plan/track.ts";
import type { Frontier } from "./frontier.ts";

/** Input of a link. Lengths mm. */
export interface Link {
  /** Distance kept from the stock while the tool crosses it and comes down on it. */
  readonly gap: number;
  /** Feed wherever material may stand. */
  readonly feed: number;
  /** Steps of the manual for the moves up and across, down at rapid, and down at feed. */
  readonly out: Purpose;
  readonly down: Purpose;
  readonly enter: Purpose;
}

/** A cutting tool: its moves, and the remaining stock in front of it. Every move at feed lowers the frontier. */
export class Cutter extends Track {
  private readonly nearest: number;

  constructor(
    frame: Frame,
    feedUnit: FeedUnit,
    start: Flat,
    room: Room,
    readonly frontier: Frontier,
    /** The tool rises no higher than this unless the stock is higher. */
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
   * From the end of one cut to the start of the next, in the same way for all cycles: up over the stock, across, and
   * down, one axis at a time. At rapid only above the frontier, the rest at feed.
   */
  link(to: Flat, l: Link): void {
    const barrier = this.frontier.over(this.at.u, to.u);
    const over = barrier > this.at.v + SAME ? Math.max(barrier, Math.min(barrier + l.gap, this.ceiling)) : -Infinity;
    const height = Math.max(this.at.v, to.v, over);
    const free = this.frontier.freeFrom(this.at.u) <= this.at.v + SAME;
    // Next to a wall the move across is free at once, the move up is not.
    if (free || !this.frontier.canCross(this.at.u, to.u, this.at.v)) this.up(height, l);
    if (this.frontier.canCross(this.at.u, to.u, this.at.v)) this.rapid("u", to.u, l.out);
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
   * Retracts from the contour at feed: at 45°, against the cutting direction (`towards` −1) or along it (1), by `by` mm
   * in either axis; straight up by the same if the part is in the way. `room`: limit of the sideways travel.
   */
  leave(by: number, towards: 1 | -1, part: Envelope, value: number, purpose: Purpose, room = by): void {
    const lift = this.limitedInBore({ u: this.at.u, v: this.at.v + by }).v - this.at.v;
    const leaning = this.limitedInBore({
      u: this.at.u + towards * Math.max(0, Math.min(lift, room)),
      v: this.at.v + lift,
    });
    this.feed(
      lift > 0 && staysAbove(part, leaning, this.at) ? leaning : { u: this.at.u, v: this.at.v + lift },
      value,
      purpose,
    );
  }

  /**
   * In a bore only a cut may lead nearer to the axis than the start point, because insert and holder would meet the
   * material on the other side. Returns the nearest allowed position, no nearer to the axis than `cut`; outside a bore
   * the point itself.
   */
  limitedInBore({ u, v }: Flat, cut: Flat = this.at): Flat {
    const { transverse, signV } = this.frame;
    if (transverse) return { u: Math.max(u, Math.min(this.nearest, cut.u)), v };
    return { u, v: signV < 0 ? Math.min(v, Math.max(this.ceiling, cut.v)) : v };
  }
}
