use cartcontact::Scalar;

fn half<T: Scalar>(_number: T) {}

fn main() {
    half(1);
}
