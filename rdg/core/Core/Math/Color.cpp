// Converts colours: sRGB by its definition (IEC 61966-2-1), HSV by its definition.
#include "Math/Color.h"

#include "Math/ToInteger.h"

namespace
{

float DecodeSrgb(uint8 Value)
{
	const double Encoded = Value / 255.0;
	return static_cast<float>(Encoded <= 0.04045 ? Encoded / 12.92 : std::pow((Encoded + 0.055) / 1.055, 2.4));
}

float EncodeSrgb(float Value)
{
	return Value <= 0.0031308f ? Value * 12.92f : std::pow(Value, 1.0f / 2.4f) * 1.055f - 0.055f;
}

uint8 Quantize(float Value)
{
	// Written so that a NaN becomes 0.
	const float Clamped = Value > 0.0f ? FMath::Min(Value, 1.0f) : 0.0f;
	return Drydock::ToInteger<uint8>(Clamped * 255.0f + 0.5f);
}

/** The number behind "Name=" in Text. */
bool ParseComponent(const FString& Text, const TCHAR* Name, float& OutValue)
{
	const int32 Position = Text.Find(Name);
	if (Position == INDEX_NONE)
	{
		return false;
	}
	const TCHAR* Start = *Text + Position + FCString::Strlen(Name);
	TCHAR* End = nullptr;
	OutValue = std::strtof(Start, &End);
	return End != Start;
}

} // namespace

FLinearColor::FLinearColor(const FColor& Color)
	: FLinearColor(DecodeSrgb(Color.R), DecodeSrgb(Color.G), DecodeSrgb(Color.B), Color.A / 255.0f)
{
}

FColor FLinearColor::ToFColor(bool bSRGB) const
{
	return bSRGB ? ToFColorSRGB() : QuantizeRound();
}

FColor FLinearColor::ToFColorSRGB() const
{
	const FLinearColor Clamped = GetClamped();
	return FLinearColor(EncodeSrgb(Clamped.R), EncodeSrgb(Clamped.G), EncodeSrgb(Clamped.B), A).QuantizeRound();
}

FColor FLinearColor::QuantizeRound() const
{
	return FColor(Quantize(R), Quantize(G), Quantize(B), Quantize(A));
}

FLinearColor FLinearColor::LinearRGBToHSV() const
{
	const float High = FMath::Max3(R, G, B);
	const float Range = High - FMath::Min3(R, G, B);
	float Hue = 0.0f;
	if (Range > 0.0f)
	{
		Hue = High == R   ? FMath::Fmod((G - B) / Range * 60.0f + 360.0f, 360.0f)
			  : High == G ? (B - R) / Range * 60.0f + 120.0f
						  : (R - G) / Range * 60.0f + 240.0f;
	}
	return {Hue, High > 0.0f ? Range / High : 0.0f, High, A};
}

FLinearColor FLinearColor::HSVToLinearRGB() const
{
	const float Sector = R / 60.0f;
	const float Fraction = Sector - std::floor(Sector);
	const float Low = B * (1.0f - G);
	const float Falling = B * (1.0f - Fraction * G);
	const float Rising = B * (1.0f - (1.0f - Fraction) * G);
	switch (Drydock::ToInteger<int32>(std::floor(Sector)) % 6)
	{
	case 0:
		return {B, Rising, Low, A};
	case 1:
		return {Falling, B, Low, A};
	case 2:
		return {Low, B, Rising, A};
	case 3:
		return {Low, Falling, B, A};
	case 4:
		return {Rising, Low, B, A};
	default:
		return {B, Low, Falling, A};
	}
}

FString FLinearColor::ToString() const
{
	return FString::Printf("(R=%f,G=%f,B=%f,A=%f)", R, G, B, A);
}

bool FLinearColor::InitFromString(const FString& Text)
{
	FLinearColor Read(0.0f, 0.0f, 0.0f, 1.0f);
	if (!ParseComponent(Text, "R=", Read.R) || !ParseComponent(Text, "G=", Read.G) ||
		!ParseComponent(Text, "B=", Read.B))
	{
		return false;
	}
	ParseComponent(Text, "A=", Read.A);
	*this = Read;
	return true;
}

FString FColor::ToString() const
{
	return FString::Printf("(R=%d,G=%d,B=%d,A=%d)", R, G, B, A);
}
