use cartcontact::GapProfile;

struct Knee;

fn contact(_profile: impl GapProfile<f64>) {}

fn main() {
    contact(Knee);
}
