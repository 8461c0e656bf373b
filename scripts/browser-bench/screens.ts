/** A measured screen: its size in points, pixels per point, and the factor that slows the processor down. */
export interface Screen {
  readonly name: string;
  readonly width: number;
  readonly height: number;
  readonly pixels: number;
  readonly slower: number;
  readonly touch: boolean;
  /** The least share of an empty page's frames while the flange plays; null where the limit is in frames per second. */
  readonly share: number | null;
  readonly perSecond: number | null;
  /** The longest time from a key to the path, ms. */
  readonly key: number;
}

/** Model of a tablet: a processor six times slower, two pixels per point. */
const TABLET = { pixels: 2, slower: 6, share: 0.8, perSecond: null, key: 50 };
const QUICK = { slower: 1, touch: false, key: 16 };

export const SCREENS: readonly Screen[] = [
  { name: "1440x900 slow", width: 1440, height: 900, touch: false, ...TABLET },
  { name: "1024x768 slow", width: 1024, height: 768, touch: true, ...TABLET },
  { name: "768x1024 slow", width: 768, height: 1024, touch: true, ...TABLET },
  { name: "1440x900", width: 1440, height: 900, pixels: 2, share: 0.8, perSecond: null, ...QUICK },
  { name: "3840x2160", width: 3840, height: 2160, pixels: 1, share: null, perSecond: 50, ...QUICK },
];
