fn main() {
    let mut args = std::env::args().skip(1).map(|a| a.parse::<u64>().unwrap_or(1));
    let cases = args.next().unwrap_or(1000);
    let seed = args.next().unwrap_or(1);
    let first = args.next().unwrap_or(0);
    let campaign = tests::stress::campaign::Campaign { seed };
    let mut report = campaign.report();
    let start = std::time::Instant::now();
    for case in first..first + cases { campaign.run(case, &mut report); }
    println!("{report}\n{:?} per case", start.elapsed() / cases as u32);
    if cases == 1 { if first % 4 == 3 { println!("{:?}", campaign.scene::<f32>(first)) } else { println!("{:?}", campaign.scene::<f64>(first)) } }
}
