// FLinearColor (four floats, linear) and FColor (four bytes, BGRA in memory, usually sRGB). Source: engine
// Math/Color.h.
#pragma once

#include "Math/Vector4.h"

struct FLinearColor
{
	using FReal = float;
	using GlmType = glm::vec<4, float, glm::defaultp>;

	float R = 0;
	float G = 0;
	float B = 0;
	float A = 0;

	static const FLinearColor White;
	static const FLinearColor Gray;
	static const FLinearColor Black;
	static const FLinearColor Transparent;
	static const FLinearColor Red;
	static const FLinearColor Green;
	static const FLinearColor Blue;
	static const FLinearColor Yellow;

	constexpr FLinearColor() = default;
	constexpr FLinearColor(float InR, float InG, float InB, float InA = 1.0f)
		: R(InR)
		, G(InG)
		, B(InB)
		, A(InA)
	{
	}
	constexpr explicit FLinearColor(EForceInit) {}
	constexpr explicit FLinearColor(const FVector3f& Vector)
		: FLinearColor(Vector.X, Vector.Y, Vector.Z)
	{
	}
	constexpr explicit FLinearColor(const FVector4f& Vector)
		: FLinearColor(Vector.X, Vector.Y, Vector.Z, Vector.W)
	{
	}
	constexpr explicit FLinearColor(const FVector& Vector)
		: FLinearColor(FVector3f(Vector))
	{
	}
	constexpr explicit FLinearColor(const FVector4& Vector)
		: FLinearColor(FVector4f(Vector))
	{
	}
	/** Converts from sRGB; alpha is linear already. */
	DRYDOCK_API FLinearColor(const FColor& Color);

	constexpr bool operator==(const FLinearColor&) const = default;
	float& Component(int32 Index) { return Index == 0 ? R : Index == 1 ? G : Index == 2 ? B : A; }
	float Component(int32 Index) const { return Index == 0 ? R : Index == 1 ? G : Index == 2 ? B : A; }
	bool Equals(const FLinearColor& Other, float Tolerance = UE_KINDA_SMALL_NUMBER) const
	{
		return FVector4f(*this).Equals(FVector4f(Other), Tolerance);
	}
	constexpr FLinearColor CopyWithNewOpacity(float Opacity) const { return {R, G, B, Opacity}; }
	constexpr FLinearColor GetClamped(float Low = 0.0f, float High = 1.0f) const
	{
		return {FMath::Clamp(R, Low, High), FMath::Clamp(G, Low, High), FMath::Clamp(B, Low, High),
			FMath::Clamp(A, Low, High)};
	}
	constexpr float GetMax() const { return FMath::Max(FMath::Max3(R, G, B), A); }
	constexpr float GetMin() const { return FMath::Min(FMath::Min3(R, G, B), A); }
	/** The engine's weights 0.3, 0.59, 0.11. */
	constexpr float GetLuminance() const { return R * 0.3f + G * 0.59f + B * 0.11f; }
	constexpr bool IsAlmostBlack() const { return R * R < UE_DELTA && G * G < UE_DELTA && B * B < UE_DELTA; }
	/** Clamped to 0..1 and rounded to nearest; bSRGB encodes the colour channels first. */
	DRYDOCK_API FColor ToFColor(bool bSRGB) const;
	DRYDOCK_API FColor ToFColorSRGB() const;
	DRYDOCK_API FColor QuantizeRound() const;
	/** Hue 0..360, saturation and value 0..1 in R, G, B. */
	DRYDOCK_API FLinearColor LinearRGBToHSV() const;
	DRYDOCK_API FLinearColor HSVToLinearRGB() const;
	/** Towards the grey of this luminance: 0 keeps the colour. */
	constexpr FLinearColor Desaturate(float Amount) const
	{
		const float Grey = GetLuminance();
		return {FMath::Lerp(R, Grey, Amount), FMath::Lerp(G, Grey, Amount), FMath::Lerp(B, Grey, Amount), A};
	}
	static FLinearColor FromSRGBColor(const FColor& Color) { return FLinearColor(Color); }
	DRYDOCK_API FString ToString() const;
	/** Reads "(R=..,G=..,B=..,A=..)"; false leaves the colour alone. A may be missing: 1. */
	DRYDOCK_API bool InitFromString(const FString& Text);
};

// The operators of all vectors, for a type that is not in their namespace.
using UE::Math::operator+;
using UE::Math::operator-;
using UE::Math::operator*;
using UE::Math::operator/;
using UE::Math::operator+=;
using UE::Math::operator-=;
using UE::Math::operator*=;
using UE::Math::operator/=;

inline const FLinearColor FLinearColor::White(1.0f, 1.0f, 1.0f);
inline const FLinearColor FLinearColor::Gray(0.5f, 0.5f, 0.5f);
inline const FLinearColor FLinearColor::Black(0.0f, 0.0f, 0.0f);
inline const FLinearColor FLinearColor::Transparent(0.0f, 0.0f, 0.0f, 0.0f);
inline const FLinearColor FLinearColor::Red(1.0f, 0.0f, 0.0f);
inline const FLinearColor FLinearColor::Green(0.0f, 1.0f, 0.0f);
inline const FLinearColor FLinearColor::Blue(0.0f, 0.0f, 1.0f);
inline const FLinearColor FLinearColor::Yellow(1.0f, 1.0f, 0.0f);

struct FColor
{
	uint8 B = 0;
	uint8 G = 0;
	uint8 R = 0;
	uint8 A = 0;

	static const FColor White;
	static const FColor Black;
	static const FColor Transparent;
	static const FColor Red;
	static const FColor Green;
	static const FColor Blue;
	static const FColor Yellow;
	static const FColor Cyan;
	static const FColor Magenta;
	static const FColor Orange;
	static const FColor Purple;
	static const FColor Turquoise;
	static const FColor Silver;
	static const FColor Emerald;

	constexpr FColor() = default;
	constexpr FColor(uint8 InR, uint8 InG, uint8 InB, uint8 InA = 255)
		: B(InB)
		, G(InG)
		, R(InR)
		, A(InA)
	{
	}
	constexpr explicit FColor(EForceInit) {}
	/** 0xAARRGGBB. */
	constexpr explicit FColor(uint32 Packed)
		: B(static_cast<uint8>(Packed))
		, G(static_cast<uint8>(Packed >> 8))
		, R(static_cast<uint8>(Packed >> 16))
		, A(static_cast<uint8>(Packed >> 24))
	{
	}

	constexpr bool operator==(const FColor&) const = default;
	constexpr uint32 ToPackedARGB() const
	{
		return static_cast<uint32>(A) << 24 | static_cast<uint32>(R) << 16 | static_cast<uint32>(G) << 8 | B;
	}
	constexpr uint32 DWColor() const { return ToPackedARGB(); }
	/** 0..255 to 0..1 without decoding. */
	constexpr FLinearColor ReinterpretAsLinear() const { return {R / 255.0f, G / 255.0f, B / 255.0f, A / 255.0f}; }
	DRYDOCK_API FString ToString() const;
};

inline constexpr FColor FColor::White(255, 255, 255);
inline constexpr FColor FColor::Black(0, 0, 0);
inline constexpr FColor FColor::Transparent(0, 0, 0, 0);
inline constexpr FColor FColor::Red(255, 0, 0);
inline constexpr FColor FColor::Green(0, 255, 0);
inline constexpr FColor FColor::Blue(0, 0, 255);
inline constexpr FColor FColor::Yellow(255, 255, 0);
inline constexpr FColor FColor::Cyan(0, 255, 255);
inline constexpr FColor FColor::Magenta(255, 0, 255);
inline constexpr FColor FColor::Orange(243, 156, 18);
inline constexpr FColor FColor::Purple(169, 7, 228);
inline constexpr FColor FColor::Turquoise(26, 188, 156);
inline constexpr FColor FColor::Silver(189, 195, 199);
inline constexpr FColor FColor::Emerald(46, 204, 113);

inline uint32 GetTypeHash(const FLinearColor& Color)
{
	return GetTypeHash(FVector4f(Color));
}
inline uint32 GetTypeHash(const FColor& Color)
{
	return GetTypeHash(Color.ToPackedARGB());
}

namespace UE::Math
{

template<typename T>
constexpr TVector<T>::TVector(const FLinearColor& Color)
	: X(Color.R)
	, Y(Color.G)
	, Z(Color.B)
{
}
template<typename T>
constexpr TVector4<T>::TVector4(const FLinearColor& Color)
	: TVector4(Color.R, Color.G, Color.B, Color.A)
{
}
template<typename T>
constexpr TVector4<T>::TVector4(const FLinearColor& Color, T InW)
	: TVector4(Color.R, Color.G, Color.B, InW)
{
}

} // namespace UE::Math
