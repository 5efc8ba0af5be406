// Names of the vector and matrix types. The suffix f means float, d double; the plain names are double, as in engine 5.
// Source: engine Math/MathFwd.h.
#pragma once

#include "CoreTypes.h"

namespace UE::Math
{

template<typename T>
struct TVector2;
template<typename T>
struct TVector;
template<typename T>
struct TVector4;
template<typename T>
struct TMatrix;
template<typename T>
struct TQuat;
template<typename T>
struct TRotator;
template<typename T>
struct TBox;
template<typename T>
struct TPlane;
template<typename T>
struct TTransform;
template<typename T>
struct TBoxSphereBounds;
template<typename IntType>
struct TIntPoint;
template<typename IntType>
struct TIntRect;
template<typename IntType>
struct TIntVector2;
template<typename IntType>
struct TIntVector3;
template<typename IntType>
struct TIntVector4;

} // namespace UE::Math

using FVector2f = UE::Math::TVector2<float>;
using FVector3f = UE::Math::TVector<float>;
using FVector4f = UE::Math::TVector4<float>;
using FVector2D = UE::Math::TVector2<double>;
using FVector2d = UE::Math::TVector2<double>;
using FVector = UE::Math::TVector<double>;
using FVector3d = UE::Math::TVector<double>;
using FVector4 = UE::Math::TVector4<double>;
using FVector4d = UE::Math::TVector4<double>;
using FMatrix = UE::Math::TMatrix<double>;
using FMatrix44d = UE::Math::TMatrix<double>;
using FMatrix44f = UE::Math::TMatrix<float>;
using FQuat = UE::Math::TQuat<double>;
using FQuat4d = UE::Math::TQuat<double>;
using FQuat4f = UE::Math::TQuat<float>;
using FRotator = UE::Math::TRotator<double>;
using FRotator3d = UE::Math::TRotator<double>;
using FRotator3f = UE::Math::TRotator<float>;
using FBox = UE::Math::TBox<double>;
using FBox3d = UE::Math::TBox<double>;
using FBox3f = UE::Math::TBox<float>;
using FPlane = UE::Math::TPlane<double>;
using FPlane4d = UE::Math::TPlane<double>;
using FPlane4f = UE::Math::TPlane<float>;
using FTransform = UE::Math::TTransform<double>;
using FTransform3d = UE::Math::TTransform<double>;
using FTransform3f = UE::Math::TTransform<float>;
using FBoxSphereBounds = UE::Math::TBoxSphereBounds<double>;
using FBoxSphereBounds3d = UE::Math::TBoxSphereBounds<double>;
using FBoxSphereBounds3f = UE::Math::TBoxSphereBounds<float>;

using FIntPoint = UE::Math::TIntPoint<int32>;
using FInt32Point = UE::Math::TIntPoint<int32>;
using FInt64Point = UE::Math::TIntPoint<int64>;
using FUintPoint = UE::Math::TIntPoint<uint32>;
using FUint32Point = UE::Math::TIntPoint<uint32>;
using FIntRect = UE::Math::TIntRect<int32>;
using FInt32Rect = UE::Math::TIntRect<int32>;
using FUintRect = UE::Math::TIntRect<uint32>;
using FIntVector2 = UE::Math::TIntVector2<int32>;
using FIntVector = UE::Math::TIntVector3<int32>;
using FIntVector3 = UE::Math::TIntVector3<int32>;
using FIntVector4 = UE::Math::TIntVector4<int32>;
using FUintVector2 = UE::Math::TIntVector2<uint32>;
using FUintVector = UE::Math::TIntVector3<uint32>;
using FUintVector3 = UE::Math::TIntVector3<uint32>;
using FUintVector4 = UE::Math::TIntVector4<uint32>;

struct FColor;
struct FLinearColor;
