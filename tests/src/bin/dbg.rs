use cartcontact::*;
fn main(){
  let p=Polynomial::new([(1.3356621f32, 0.75f32)]).unwrap();
  let l=load::PiecewiseLinear::new([(0.0f32,0.0f32),(7.6141624, 9.732083e-11)]).unwrap();
  let c=Contact::new(p,Medium::from_constants(0.31216568f32,0.0014122127).unwrap(),l).unwrap();
  let s=c.at(7.0810857).unwrap();
  let a=s.radius();
  println!("{a:e} J {:e} slope {:e} P {:e} {:e}",c.profile().load_integral(a),c.profile().approach_slope(a),s.pressure(0.0),s.pressure(a*0.5));
  let p=Polynomial::new([(1.6335868020401498f64, 2.0), (7.979848106037263e-7, 12.0), (1.759840036174963e-27, 64.0)]).unwrap();
  let l=load::PiecewiseLinear::new([(0.0,0.0),(382299.27100902295, 16.72999224357565)]).unwrap();
  let c=Contact::new(p,Medium::from_constants(6.317618241965802,5.123840263420603e-6).unwrap(),l).unwrap();
  let s=c.at(195166.11537230364).unwrap();
  let a=s.radius();
  println!("{a:e} J {:e} slope {:e} P {:e} {:e}",c.profile().load_integral(a),c.profile().approach_slope(a),s.pressure(0.0),s.pressure(a*0.5));
}
