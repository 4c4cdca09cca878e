//! stub
use crate::message::Result; use crate::pose::*;
pub struct Fit { pub point_mm: Vector, pub direction: Option<Vector>, pub radius_mm: Option<f64> }
impl Fit { pub fn rms_mm(&self)->f64{0.0} pub fn max_mm(&self)->f64{0.0} pub fn standard_uncertainty_mm(&self)->Option<f64>{None} }
pub fn plane(p:&[Vector])->Result<Fit>{ let c=centroid(p).unwrap(); let mut m=[[0.0;3];3]; for q in p {let d=minus(*q,c); for i in 0..3{for j in 0..3{m[i][j]+=d[i]*d[j];}}} let (_,v)=crate::solve::symmetric_eigen(m); Ok(Fit{point_mm:c,direction:Some(v[0]),radius_mm:None}) }
pub fn line(_:&[Vector])->Result<Fit>{unimplemented!()}
pub fn circle3d(_:&[Vector])->Result<Fit>{unimplemented!()}
pub fn cylinder(_:&[Vector])->Result<Fit>{unimplemented!()}
pub struct RigidFit{pub to_t_from: Pose, pub residuals_mm: Vec<f64>}
pub fn rigid(from:&[Vector],to:&[Vector])->Result<RigidFit>{
 let a=centroid(from).unwrap(); let b=centroid(to).unwrap();
 let mut s=[[0.0;3];3]; for (f,t) in from.iter().zip(to){let f=minus(*f,a);let t=minus(*t,b); for i in 0..3{for j in 0..3{s[i][j]+=f[i]*t[j];}}}
 let n=[[s[0][0]+s[1][1]+s[2][2],s[1][2]-s[2][1],s[2][0]-s[0][2],s[0][1]-s[1][0]],
 [s[1][2]-s[2][1],s[0][0]-s[1][1]-s[2][2],s[0][1]+s[1][0],s[2][0]+s[0][2]],
 [s[2][0]-s[0][2],s[0][1]+s[1][0],-s[0][0]+s[1][1]-s[2][2],s[1][2]+s[2][1]],
 [s[0][1]-s[1][0],s[2][0]+s[0][2],s[1][2]+s[2][1],-s[0][0]-s[1][1]+s[2][2]]];
 let (_,v)=crate::solve::symmetric_eigen(n); let [w,x,y,z]=v[3];
 let r=[[1.0-2.0*(y*y+z*z),2.0*(x*y-w*z),2.0*(x*z+w*y)],[2.0*(x*y+w*z),1.0-2.0*(x*x+z*z),2.0*(y*z-w*x)],[2.0*(x*z-w*y),2.0*(y*z+w*x),1.0-2.0*(x*x+y*y)]];
 let mut p=Pose{rotation:r,translation_mm:[0.0;3]}; p.translation_mm=minus(b,p.rotate(a));
 let res=from.iter().zip(to).map(|(f,t)|norm(minus(p.apply(*f),*t))).collect(); Ok(RigidFit{to_t_from:p,residuals_mm:res})}
