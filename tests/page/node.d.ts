// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests use of Node, for the type check: Debian's typescript comes without its types.
declare module "node:test" {
  export default function test(name: string, body: () => void): void;
}
declare module "node:assert/strict" {
  interface Assert {
    ok(value: unknown, message?: string): asserts value;
    equal<T>(actual: T, expected: T, message?: string): void;
    deepEqual<T>(actual: T, expected: T, message?: string): void;
    throws(body: () => void, message?: string): void;
  }
  const assert: Assert;
  export default assert;
}
