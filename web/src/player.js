// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Time that runs: play, pause, step, speed, loop.

export class Player {
  constructor(onTime) {
    this.onTime = onTime;
    this.speed = 0.25;
    this.loopsCycle = false;
    this.isPlaying = false;
  }

  /** Takes another stage's motion; the time stays where both have it. */
  load(motion) {
    this.motion = motion;
    const start = Math.max(motion.begin, motion.end - motion.cycleTime);
    if (this.time === undefined || this.time < motion.begin || this.time > motion.end) this.time = start;
    this.show(this.time);
  }

  /** Where the loop begins: one cycle before the end of the cycle that is shown, or the first sample. */
  get loop() {
    const { begin, end, cycleTime } = this.motion;
    if (!this.loopsCycle || !(cycleTime > 0)) return [begin, end];
    const first = Math.min(begin + Math.floor((this.loopAt - begin) / cycleTime) * cycleTime, Math.max(begin, end - cycleTime));
    return [first, Math.min(end, first + cycleTime)];
  }

  setLoop(on) {
    this.loopsCycle = on;
    this.loopAt = this.time;
  }

  show(time) {
    this.time = Math.min(this.motion.end, Math.max(this.motion.begin, time));
    if (!this.isPlaying) this.loopAt = this.time;
    this.onTime(this.time);
  }

  /** One recorded sample on or back. */
  step(n) {
    this.pause();
    const { times } = this.motion;
    let k = 0;
    while (k + 1 < times.length && times[k + 1] <= this.time + 1e-12) ++k;
    this.show(times[Math.min(times.length - 1, Math.max(0, k + n))]);
  }

  toggle() {
    if (this.isPlaying) this.pause();
    else this.play();
  }

  play() {
    if (this.isPlaying) return;
    this.loopAt ??= this.time;
    this.isPlaying = true;
    let last = performance.now();
    const advance = (now) => {
      if (!this.isPlaying) return;
      const [begin, end] = this.loop;
      let next = this.time + (this.speed * Math.min(now - last, 100)) / 1000;
      if (next > end || next < begin) next = begin;
      last = now;
      this.show(next);
      requestAnimationFrame(advance);
    };
    requestAnimationFrame(advance);
  }

  pause() { this.isPlaying = false; }
}
