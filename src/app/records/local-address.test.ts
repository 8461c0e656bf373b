import { expect, test } from "vitest";
import { isLocalAddress } from "./local-address.ts";

test.each([
  ["http://localhost:4173/", true],
  ["http://shop.localhost/turnwise/", true],
  ["http://127.0.0.1:8080/", true],
  ["http://127.44.0.3/", true],
  ["http://[::1]:4173/turnwise/index.html", true],
  ["file:///C:/turnwise/index.html", true],
  ["https://turnwise.example/", false],
  ["http://192.168.127.1/", false],
  ["http://10.127.0.1:4173/", false],
  ["http://localhost.example/", false],
  ["http://notlocalhost/", false],
  ["http://127.0.0.1.example/", false],
  ["http://[fe80::1]/", false],
])("that %s is on this device only: %s", (page, isHere) => expect(isLocalAddress(page)).toBe(isHere));
