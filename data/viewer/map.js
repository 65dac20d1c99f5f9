// Maps of a field on the sphere, one for each snapshot: the one of the moment, or the last before it.

class MapView {
  /** @param image  the element that shows a map  @param maps  their times and pictures, and the largest modulus */
  constructor(image, maps) {
    Object.assign(this, { image, maps, shown: {}, at: -1 });
  }
  draw({ t }) {
    const { times, pictures } = this.maps, near = 1e-9 * (times[times.length - 1] - times[0]);
    let at = 0;
    while (at + 1 < times.length && times[at + 1] <= t + near) ++at;
    if (at === this.at) return;
    this.at = at;
    this.image.src = "data:image/png;base64," + pictures[at];
    this.image.alt = `The vorticity at t = ${shownNumber(times[at])}: longitudes from 0 to 360° to the right, the north pole above`;
  }
}
