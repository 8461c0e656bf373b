/** Text that makes the time of a pattern grow faster than its length when it is repeated; null for a linear one. */
export declare function growthOf(source: string, flags: string): string | null;
